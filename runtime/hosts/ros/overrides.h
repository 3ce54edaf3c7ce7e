/* overrides.h -- values of parameters in the arguments for ROS: `--ros-args -p kTurn:=5.0`. */
#ifndef FROB_HOST_ROS_OVERRIDES_H
#define FROB_HOST_ROS_OVERRIDES_H

#include <frob/program.h>

/* A command line with the program's own options. */
struct overrides {
    int argc;
    char **argv; /* NULL if memory ran out */
};

/* Returns the command line, with an option `--param NAME=VALUE` for each value of a parameter of the
 * program in the arguments for ROS. Reports names that the program does not have, and use_sim_time,
 * which this host does not support. The result is never freed. */
struct overrides overrides_of(int argc, char **argv, const struct frob_program *program);

#endif
