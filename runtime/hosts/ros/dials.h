/* dials.h -- the program's knobs and toggles, which other nodes set as parameters of the node. */
#ifndef FROB_HOST_ROS_DIALS_H
#define FROB_HOST_ROS_DIALS_H

#include <frob/program.h>

#include "messages.h"

struct ros_device;

/* Handles a change to one of the node's parameters. */
void ros_take_touch(struct ros_device *device, const struct ros_touch *touch);

/* Applies the knob and toggle values that other nodes have set, and sends the node those that the
 * operator has set here. */
void ros_give_dials(struct ros_device *device, const struct frob_program *program, void *input);

#endif
