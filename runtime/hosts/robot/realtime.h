/* realtime.h -- real-time priority and locked memory. */
#ifndef FROB_HOST_ROBOT_REALTIME_H
#define FROB_HOST_ROBOT_REALTIME_H

#include "options.h"

enum realtime_process { REALTIME_SUPERVISOR, REALTIME_CONTROLLER };

/* Applies the real-time options to this process. If the system does not permit them, the supervisor
 * prints a warning, and the run continues without them. */
void realtime_apply(const struct options *options, enum realtime_process process);

#endif
