/* supervisor.h -- the process that holds the robot's line.
 *
 * It alone speaks with the robot. The program's step runs in another process
 * (controller.h), and a third one watches over this one (guard.h):
 *
 *   controller  ── input, output ──  supervisor  ── line ──  robot
 *                                        │                     │
 *                                      guard  ── line ─────────┘
 *
 * What stops the robot: no fresh reading for the patience; a step that is not
 * finished within it; the controller's end; a signal; the end of the run. A
 * line that is lost is opened again when the device is back. */
#ifndef FROB_HOST_ROBOT_SUPERVISOR_H
#define FROB_HOST_ROBOT_SUPERVISOR_H

#include <frob/program.h>

#include "../common/params.h"
#include "drivers/driver.h"
#include "options.h"

/* Runs the program of these parameters on the robot; the exit status, after a summary. */
int supervise(const struct params *params, const struct frob_driver *driver,
              const struct options *options);

#endif
