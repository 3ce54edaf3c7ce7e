/* summary.h -- summarizes a run, with one `name: value unit` per line. */
#ifndef FROB_SIM_SUMMARY_H
#define FROB_SIM_SUMMARY_H

#include "controllers.h"
#include "options.h"

/* Prints the summary on standard output. If there are several robots, prints one for each, named
 * `robot 1` and so on, and then one for all together. `wall_s` is the run's duration in real time.
 * Returns the total number of collisions. */
int summary_print(const struct options *options, const struct controllers *c, double wall_s);

#endif
