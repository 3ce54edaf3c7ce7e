/* realtime.h -- real-time priority and memory that stays. */
#ifndef FROB_HOST_ROBOT_REALTIME_H
#define FROB_HOST_ROBOT_REALTIME_H

#include "options.h"

enum realtime_process { REALTIME_SUPERVISOR, REALTIME_CONTROLLER };

/* Does for this process what the options ask for. What is not allowed is told
 * (once, by the supervisor), and the run goes on without. */
void realtime_apply(const struct options *options, enum realtime_process process);

#endif
