/* overrides.h -- parameter values in the ROS arguments: `--ros-args -p kTurn:=5.0`. */
#ifndef FROB_HOST_ROS_OVERRIDES_H
#define FROB_HOST_ROS_OVERRIDES_H

#include <frob/program.h>

#include "parameters.h"

/* A command line with the program's own options. */
struct overrides {
    int argc;
    char **argv; /* NULL if memory ran out or a value is invalid */
};

/* Returns the command line with an additional option `--param NAME=VALUE` for each of the program's
 * parameters that the ROS arguments set, and with a driver setting if they set use_sim_time.
 * Replaces the option `--lifecycle` with a driver setting. Reports unknown parameter names and
 * invalid values. The result is never freed. */
struct overrides overrides_of(int argc, char **argv, const struct frob_program *program);

/* Calls `set` for each knob or toggle that the arguments set, with its new value. `program`: the
 * program's name. */
void overrides_of_controls(int argc, char **argv, const char *program,
                           const struct parameters *parameters,
                           void (*set)(void *context, struct parameter *parameter, double value),
                           void *context);

#endif
