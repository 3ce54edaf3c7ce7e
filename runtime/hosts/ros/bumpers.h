/* bumpers.h -- the bumpers of the robot `ros`. A program that reads a bumper has a control of the
 * kind FROB_HOLD with the bumper's label, and the node subscribes to a topic of std_msgs/msg/Bool.
 * The name of this topic differs between robots, so the user must specify it. */
#ifndef FROB_HOST_ROS_BUMPERS_H
#define FROB_HOST_ROS_BUMPERS_H

#include <frob/program.h>

#include <stdbool.h>
#include <stddef.h>

/* Returns the name of the topic before remapping, such as `bumper_left`; NULL if the control is not
 * a bumper. */
const char *bumpers_topic(const struct frob_control *control);

/* Checks that the arguments for ROS remap the topic of each bumper that the program reads. On
 * failure, writes a one-line message. */
bool bumpers_check(const struct frob_program *program, const char *const *arguments, size_t count,
                   char *message, size_t room);

#endif
