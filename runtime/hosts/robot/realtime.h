/* realtime.h -- real-time priority and locked memory. */
#ifndef FROB_HOST_ROBOT_REALTIME_H
#define FROB_HOST_ROBOT_REALTIME_H

#include "options.h"

enum realtime_process { REALTIME_SUPERVISOR, REALTIME_CONTROLLER };

/* Applies the options to this process. If the system does not permit this, the supervisor
 * prints a warning, and the run continues without it. */
void realtime_apply(const struct options *options, enum realtime_process process);

#endif
