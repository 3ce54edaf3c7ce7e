#include "create2.h"

#include "drivers/create/command.h"

namespace frob::sim::create2 {
namespace {

constexpr double mass = 3.5;               // kg
constexpr double wheel_radius = 0.036;     // m
constexpr double wheel_separation = 0.235; // m
constexpr double counts_per_turn = 508.8;

std::vector<Pose> seats() {
    std::vector<Pose> seats;
    for (const double degrees : {65.0, 38.0, 12.0, -12.0, -38.0, -65.0})
        seats.push_back({radius * direction(radians(degrees)), radians(degrees)});
    return seats;
}

} // namespace

// The inertia is that of a uniform disc. Accelerations and forces are estimates.
const Chassis &chassis() {
    static const Chassis chassis = {
        "Create 2",
        mass,
        mass * radius * radius / 2.0,
        {0.0, 0.0},
        radius,
        {},
        wheel_radius,
        wheel_separation,
        8.0,
        2 * pi * wheel_radius / counts_per_turn,
        16.0,
        {0.5, radians(240.0), 0.9, radians(400.0)},
        frob_create_wire(wheel_separation),
        {0.0, radius},
        {0.0, -radius},
        {seats(), 0.0, 0, 5, {2, 3}, "light bumper"},
    };
    return chassis;
}

} // namespace frob::sim::create2
