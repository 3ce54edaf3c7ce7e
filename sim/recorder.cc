#include "recorder.h"

namespace frob::sim {

void Recorder::add(const Sample &sample) {
    if (!samples_.empty())
        distance_driven_ += length(sample.pose.position - samples_.back().pose.position);
    samples_.push_back(sample);
}

} // namespace frob::sim
