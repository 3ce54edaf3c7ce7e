/* own.h -- the driver for a node with topics of its own (`node` of the library's module Ros). The
 * topics are its sensors and its commands. It uses the same line as device.h. */
#ifndef FROB_HOST_ROS_OWN_H
#define FROB_HOST_ROS_OWN_H

#include "drivers/driver.h"
#include <frob/program.h>

/* Returns the driver for this program, which has topics of its own. There is only one in a process.
 */
const struct frob_driver *ros_own_driver(const struct frob_program *program);

#endif
