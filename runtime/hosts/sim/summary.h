/* summary.h -- how a run went, one `name: value unit` a line. */
#ifndef FROB_SIM_SUMMARY_H
#define FROB_SIM_SUMMARY_H

#include "controllers.h"
#include "options.h"

/* Prints it on standard output: of a single robot; or of each of several, named
 * `robot 1` and so on, and then of all together. `wall_s` is how long it took.
 * Returns the collisions of all. */
int summary_print(const struct options *options, const struct controllers *c, double wall_s);

#endif
