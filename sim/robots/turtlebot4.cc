#include "turtlebot4.h"

namespace frob::sim::turtlebot4 {
namespace {

// The radius, the wheels, and the limits of the controller are from iRobot's model of the base. The
// mass is that of the whole robot.
constexpr double radius = 0.171;           // m
constexpr double wheel_radius = 0.03575;   // m
constexpr double wheel_separation = 0.233; // m
constexpr double mass = 3.9;               // kg
constexpr double wheel_force = 8.0;        // N, an estimate
constexpr double battery = 14.4;           // V, an estimate

} // namespace

// The inertia is that of a uniform disc. The robot accepts speeds without rounding. It has no range
// finders: the last entry contains only the position of the robot's front, which is needed to draw
// the robot.
const Chassis &chassis() {
    static const Chassis chassis = {
        "TurtleBot 4",
        mass,
        mass * radius * radius / 2.0,
        {0.0, 0.0},
        radius,
        {},
        wheel_radius,
        wheel_separation,
        wheel_force,
        0.0,
        battery,
        {0.46, 1.9, 0.9, 7.725},
        {false, {0.0, 0.0}, {0.46, 1.9}, wheel_separation},
        {0.0, radius},
        {0.0, -radius},
        {{{{radius, 0.0}, 0.0}}, 0.0, 0, 0, {0}, "ranger"},
    };
    return chassis;
}

} // namespace frob::sim::turtlebot4
