// The order in which a robot's sonars fire, and the range of their readings.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace frob::sim {

// Transducers that fire in turn.
struct SonarArray {
    std::vector<std::size_t> order; // their indices in RangeFinders::seats
    std::int64_t first_ping_ns;     // since the start
};

struct SonarRing {
    std::int64_t ping_ns;           // time from one ping of an array to the next
    std::vector<SonarArray> arrays; // arrays that fire in parallel
    double nearest;                 // m; the reading for any nearer object
    double farthest;                // m; farther objects return no echo
    double resolution;              // m; 0: continuous
};

} // namespace frob::sim
