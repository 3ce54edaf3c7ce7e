/* opening.h -- opens the line to the robot `ros` by starting the node's process (node.h). */
#ifndef FROB_HOST_ROS_OPENING_H
#define FROB_HOST_ROS_OPENING_H

#include "hosts/robot/line.h"

/* The first command-line argument of the node's process. */
#define ROS_NODE_OPTION "--ros-node"

extern const struct line_opening ros_opening;

/* If the command line starts the node's process, runs the node, sets `status` to its exit status,
 * and returns true. */
bool ros_is_node(int argc, char **argv, const struct frob_program *program, int *status);

#endif
