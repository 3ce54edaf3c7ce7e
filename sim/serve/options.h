// The command line of frob-serve.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace frob::serve
{

struct Options {
    std::string robot = "pioneer";
    std::string model = "p3dx-sh"; // of the Pioneer: its subclass
    std::string world;
    std::uint64_t seed = 1;
    int tcp_port = -1;       // a pseudo-terminal instead if negative
    int camera_port = -1;    // for the world's cameras; none if negative
    double duration_s = 0.0; // 0: until it is ended
    std::uint32_t rate = 0;  // of the line at first; 0: what is usual for the robot
    bool paced = true;       // bytes take their time
    std::string log;         // of commands; empty: none
    std::string link;        // a symbolic link kept to the device; empty: none
    double wall_distance_m = 0.0;
    std::string own; // the shared object of a robot of the user's own; empty: none
};

struct WrongUse : std::runtime_error {
    using std::runtime_error::runtime_error;
};

extern const char usage[];

// Throws WrongUse.
Options read_options(int argc, char **argv);

} // namespace frob::serve
