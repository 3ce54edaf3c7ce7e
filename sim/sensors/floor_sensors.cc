#include "floor_sensors.h"

#include <algorithm>

namespace frob::sim {

// The noise is relative: seen = reflectance * (1 + noise * n), n normal.
void FloorSensors::advance(std::int64_t time_ns, const Body &body, const Floor &floor) {
    if (time_ns % refresh_ns_ != 0) return;
    const Pose pose = body.pose();
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const double gain = 1.0 + settings_.noise * noise_.normal();
        seen_[i] = std::max(0.0, gain * floor.reflectance(from_frame(pose, places_[i]), spot_));
    }
}

} // namespace frob::sim
