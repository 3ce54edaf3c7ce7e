/* opening.h -- opens the line of the robot `ros`: starts the process of the node (node.h). */
#ifndef FROB_HOST_ROS_OPENING_H
#define FROB_HOST_ROS_OPENING_H

#include "hosts/robot/line.h"

/* The first argument of this executable in the process of the node. */
#define ROS_NODE_OPTION "--ros-node"

extern const struct line_opening ros_opening;

/* If this is the command line of a node, runs the node, and returns true and the node's exit
 * status. */
bool ros_is_node(int argc, char **argv, const struct frob_program *program, int *status);

#endif
