#include "recorder.h"

namespace frob::sim {

void Recorder::arrive(Vec position) {
    if (last_) distance_driven_ += length(position - *last_);
    last_ = position;
}

} // namespace frob::sim
