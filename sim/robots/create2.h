// Dimensions and constants of iRobot's Create 2. The values are the same as in stdlib/Create.frob,
// which lists the sources and says which values are estimates.
#pragma once

#include <array>

#include "chassis.h"

namespace frob::sim::create2 {

constexpr double radius = 0.17425; // m

// The signal of a light bumper times the squared distance to the wall, m^2.
constexpr double light_constant = 2.5;
constexpr int largest_signal = 4095;
constexpr double farthest_light = 1.5; // m, the distance beyond which there is no signal
constexpr int faintest_light = 10;     // the weakest signal that sets a light bumper's bit: that of
                                       // a wall 0.5 m away

// Positions of the cliff sensors in m, from left to right, as in create_robot's model.
constexpr std::array<Vec, 4> cliff_places = {
    {{0.07, 0.14}, {0.15, 0.04}, {0.15, -0.04}, {0.07, -0.14}}};
constexpr double cliff_spot = 0.02;     // m, the width of the spot that each sensor sees; an
                                        // estimate
constexpr double white_signal = 1500.0; // the signal of a cliff sensor above a white floor

const Chassis &chassis();

} // namespace frob::sim::create2
