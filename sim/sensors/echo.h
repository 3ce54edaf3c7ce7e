// What a transducer that measures distances heard or saw.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "body.h"

namespace frob::sim
{

struct Echo {
    std::int64_t time_ns;   // at which it arrived
    std::size_t transducer; // by its seat
    double distance;        // m, from the transducer
    Pose from;              // of the transducer in the world when it fired
};

// The distance to the nearest thing anywhere in a transducer's cone: what is
// heard first. `rays` are cast.
std::optional<double> nearest_in_cone(const Body &body, const Pose &transducer, double half_angle,
                                      double reach, int rays);

} // namespace frob::sim
