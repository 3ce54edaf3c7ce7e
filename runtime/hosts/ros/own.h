/* own.h -- the driver for a node with its own topics (`node` of the library's module Ros). The
 * topics are its sensors and its commands. It uses the same connection to the node as the driver in
 * device.h. */
#ifndef FROB_HOST_ROS_OWN_H
#define FROB_HOST_ROS_OWN_H

#include "drivers/driver.h"
#include <frob/program.h>

/* Returns the driver for this program, which must have its own topics. A process has only one such
 * driver. */
const struct frob_driver *ros_own_driver(const struct frob_program *program);

#endif
