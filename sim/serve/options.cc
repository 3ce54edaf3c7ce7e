#include "options.h"

#include <cmath>
#include <cstdlib>

#include "robots.h"

namespace frob::serve {

const char usage[] =
    "usage: frob-serve --world WORLD.toml [OPTION]...\n"
    "\n"
    "Simulates a robot and its serial protocol in real time. The first line on\n"
    "standard output is `device: ` and the device to connect to.\n"
    "\n"
    "  --robot ROBOT      pioneer, scout or create\n"
    "  --model SUBCLASS   model of the pioneer: p3dx-sh, p3dx or p2dx\n"
    "  --own FILE.so      your own robot, compiled from its C files; --robot is its name\n"
    "  --world FILE       the world of the robot\n"
    "  --seed N           the seed for all noise (1)\n"
    "  --tcp PORT         listen on 127.0.0.1 instead of a pseudo-terminal; 0: any free port\n"
    "  --camera PORT      serve the cameras as MJPEG over HTTP on 127.0.0.1; 0: any free port\n"
    "  --for SECONDS      how long to run (until interrupted)\n"
    "  --rate BITS        initial bit rate of the line (the robot's usual rate)\n"
    "  --unpaced          transmit bytes without delay\n"
    "  --log FILE         log each command to this file, with its time on the monotonic clock\n"
    "  --link PATH        maintain a symbolic link to the device\n"
    "  --target METRES    the distance that the robot should keep from the wall\n"
    "  --node FILE        for the robot `ros`: executable of its node, instead of a serial line\n"
    "  --stamped          for the robot `ros`: cmd_vel has the type TwistStamped\n"
    "  --ros-args ARG...  pass all the following arguments to ROS 2\n"
    "\n"
    "SIGUSR1 unplugs the cable; SIGUSR2 plugs it in again, as another device.\n";

namespace {

double number(const std::string &option, const std::string &text, double low, double high) {
    char *end = nullptr;
    const double x = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !(x >= low && x <= high))
        throw WrongUse(option + " takes a number from " + std::to_string(low) + " to " +
                       std::to_string(high) + ", not `" + text + "`");
    return x;
}

std::uint64_t whole(const std::string &option, const std::string &text, std::uint64_t most) {
    char *end = nullptr;
    const std::uint64_t n = std::strtoull(text.c_str(), &end, 10);
    if (text.empty() || text[0] < '0' || text[0] > '9' || *end != '\0' || n > most)
        throw WrongUse(option + " takes a whole number up to " + std::to_string(most) + ", not `" +
                       text + "`");
    return n;
}

void set(Options &o, const std::string &option, const std::string &value) {
    if (option == "--robot")
        o.robot = value;
    else if (option == "--model")
        o.model = value;
    else if (option == "--world")
        o.world = value;
    else if (option == "--seed")
        o.seed = whole(option, value, UINT64_MAX);
    else if (option == "--tcp")
        o.tcp_port = static_cast<int>(whole(option, value, 65535));
    else if (option == "--camera")
        o.camera_port = static_cast<int>(whole(option, value, 65535));
    else if (option == "--for")
        o.duration_s = number(option, value, 0.0, 1e6);
    else if (option == "--rate")
        o.rate = static_cast<std::uint32_t>(whole(option, value, 4000000));
    else if (option == "--log")
        o.log = value;
    else if (option == "--link")
        o.link = value;
    else if (option == "--own")
        o.own = value;
    else if (option == "--node")
        o.node = value;
    else if (option == "--target")
        o.wall_distance_m = number(option, value, 0.001, 100.0);
    else
        throw WrongUse("unknown option `" + option + "`; `frob-serve --help` lists all options");
}

} // namespace

Options read_options(int argc, char **argv) {
    Options o;
    for (int i = 1; i < argc; ++i) {
        const std::string option = argv[i];
        if (option == "--unpaced") {
            o.paced = false;
        } else if (option == "--stamped") {
            o.stamped = true;
        } else if (option == "--ros-args") {
            o.ros_arguments.assign(argv + i, argv + argc);
            break;
        } else if (i + 1 == argc) {
            throw WrongUse("the option `" + option + "` is unknown, or its value is missing");
        } else {
            set(o, option, argv[++i]);
        }
    }
    if (o.world.empty()) throw WrongUse("--world is missing; see `frob-serve --help`");
    if (!o.node.empty()) {
        if (o.tcp_port >= 0 || !o.link.empty() || o.rate != 0)
            throw WrongUse("a robot in ROS 2 has no serial line: remove --tcp, --link and --rate");
        return o;
    }
    // The board of a user-defined robot determines the rate.
    if (!o.own.empty()) return o;
    const std::uint32_t usual = usual_rate(o.robot);
    if (usual == 0)
        throw WrongUse("there is no simulated `" + o.robot +
                       "` with a serial line; use pioneer, scout or create");
    if (o.rate == 0) o.rate = usual;
    return o;
}

} // namespace frob::serve
