// The measures of iRobot's Create 2. Sources, and what is only estimated:
// stdlib/Create.frob, whose numbers these are.
#pragma once

#include <array>

#include "chassis.h"

namespace frob::sim::create2 {

constexpr double radius = 0.17425; // m

// Signal of a light bumper times the square of the distance to a wall, m^2.
constexpr double light_constant = 2.5;
constexpr int largest_signal = 4095;
constexpr double farthest_light = 1.5; // m; what is farther gives no signal

// Where the cliff sensors look down, from the left to the right, and where the
// wheels stand. Estimates.
constexpr double cliff_radius = 0.16; // m
constexpr std::array<double, 4> cliff_angles = {radians(60), radians(15), radians(-15),
                                                radians(-60)};

const Chassis &chassis();

} // namespace frob::sim::create2
