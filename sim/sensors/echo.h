// The echo that a distance-measuring transducer receives.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "body.h"

namespace frob::sim {

struct Echo {
    std::int64_t time_ns;   // time of arrival
    std::size_t transducer; // its index in RangeFinders::seats
    double distance;        // m, from the transducer
    Pose from;              // pose of the transducer in the world when it fired
};

// The distance to the nearest object in a transducer's cone, because its echo arrives first.
// Casts `rays` rays.
std::optional<double> nearest_in_cone(const Body &body, const Pose &transducer, double half_angle,
                                      double reach, int rays);

} // namespace frob::sim
