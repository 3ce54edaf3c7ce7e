// Dimensions of a TurtleBot 4, whose base is an iRobot Create 3.
#pragma once

#include "chassis.h"

namespace frob::sim::turtlebot4 {

const Chassis &chassis();

} // namespace frob::sim::turtlebot4
