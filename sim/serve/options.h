// The command line of frob-serve.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace frob::serve {

struct Options {
    std::string robot = "pioneer";
    std::string model = "p3dx-sh"; // the Pioneer's subclass
    std::string world;
    std::uint64_t seed = 1;
    int tcp_port = -1;       // negative: use a pseudo-terminal instead
    int camera_port = -1;    // port that serves the world's cameras; negative: none
    double duration_s = 0.0; // 0: until interrupted
    std::uint32_t rate = 0;  // the line's initial rate; 0: the robot's usual rate
    bool paced = true;       // whether bytes are sent as slowly as on a real line
    std::string log;         // file for the log of commands; empty if there is none
    std::string link;        // symbolic link to the device; empty if there is none
    double wall_distance_m = 0.0;
    std::string own; // shared object with a user-defined robot; empty if there is none
    // For a robot in ROS 2:
    std::string node;     // executable of the node; empty if the robot has a serial
                          // line
    bool stamped = false; // whether velocities are of the type TwistStamped
    std::vector<std::string> ros_arguments;
};

struct WrongUse : std::runtime_error {
    using std::runtime_error::runtime_error;
};

extern const char usage[];

// Throws WrongUse.
Options read_options(int argc, char **argv);

} // namespace frob::serve
