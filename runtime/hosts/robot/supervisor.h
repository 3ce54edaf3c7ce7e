/* supervisor.h -- the process that owns the robot's line.
 *
 * Only the supervisor communicates with the robot. The program's step runs in another process
 * (controller.h), and two others guard this one (guard.h):
 *
 *   controller  ── input, output ──  supervisor  ── line ──  robot
 *                                        │                     │
 *                                    guards  ── line ─────────┘
 *
 * The supervisor stops the robot if there is no fresh reading within the `--patience` time, if a
 * step takes longer than that, if the controller ends, on a signal, and at the end of the run. A
 * lost line is reopened when the device is back. */
#ifndef FROB_HOST_ROBOT_SUPERVISOR_H
#define FROB_HOST_ROBOT_SUPERVISOR_H

#include <frob/program.h>

#include "../common/params.h"
#include "drivers/driver.h"
#include "options.h"

/* Runs the program with these parameters on the robot, and prints a summary. Returns the exit
 * status. */
int supervise(const struct params *params, const struct frob_driver *driver,
              const struct options *options);

#endif
