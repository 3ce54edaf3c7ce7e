// How the sonars of a robot take turns, and what they can hear.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace frob::sim
{

// Transducers that fire one after the other.
struct SonarArray {
    std::vector<std::size_t> order; // by their seats
    std::int64_t first_ping_ns;     // since the start
};

struct SonarRing {
    std::int64_t ping_ns;           // from one transducer of an array to the next
    std::vector<SonarArray> arrays; // they work at the same time
    double nearest;                 // m; what is nearer reads so
    double farthest;                // m; what is farther gives no echo
    double resolution;              // m; 0: none
};

} // namespace frob::sim
