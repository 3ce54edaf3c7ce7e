/* host.h -- the main function of executables that drive a robot. */
#ifndef FROB_HOST_ROBOT_HOST_H
#define FROB_HOST_ROBOT_HOST_H

#include <frob/program.h>

#include "drivers/driver.h"
#include "line.h"

/* Runs the program on a robot as the command line specifies. Returns the exit status: 0; 2 for a
 * usage error, for arithmetic that does not meet the requirements in <frob/arithmetic.h>, or for a
 * line that cannot be opened; 4 if a signal or a fault ended the run, after the robot was stopped.
 * `opening`: NULL for a serial line. */
int host_run(int argc, char **argv, const struct frob_program *program,
             const struct frob_driver *driver, const struct line_opening *opening);

#endif
