// The measures of iRobot's Create 2. Sources, and what is only estimated:
// stdlib/Create.frob, whose numbers these are.
#pragma once

#include <array>

#include "chassis.h"

namespace frob::sim::create2
{

constexpr double radius = 0.17425; // m

// Signal of a light bumper times the square of the distance to a wall, m^2.
constexpr double light_constant = 2.5;
constexpr int largest_signal = 4095;
constexpr double farthest_light = 1.5; // m; what is farther gives no signal
constexpr int faintest_light = 10;     // of a wall that sets a light bumper's bit, 0.5 m off

// Where the cliff sensors look down, from the left to the right, m: as in
// create_robot's model.
constexpr std::array<Vec, 4> cliff_places = {
    { { 0.07, 0.14 }, { 0.15, 0.04 }, { 0.15, -0.04 }, { 0.07, -0.14 } }
};
constexpr double cliff_spot = 0.02;     // m, the width of what each sees; an estimate
constexpr double white_signal = 1500.0; // of a white floor

const Chassis &chassis();

} // namespace frob::sim::create2
