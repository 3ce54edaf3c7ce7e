/* summary.h -- prints the summary at the end of a run. */
#ifndef FROB_HOST_ROBOT_SUMMARY_H
#define FROB_HOST_ROBOT_SUMMARY_H

#include "run.h"

/* Returns false if the summary could not be written. */
bool summary_print(const struct run *s);

#endif
