/* guard.h -- a process that stops the robot when the supervisor itself is gone
 * or has stopped.
 *
 * The guard holds the line too. It does nothing while it hears from the
 * supervisor; when it does not for the patience, it tells the robot to stop,
 * and again ten times a second until the supervisor is back. When the
 * supervisor has ended without ending the guard, it stops the robot and ends. */
#ifndef FROB_HOST_ROBOT_GUARD_H
#define FROB_HOST_ROBOT_GUARD_H

#include <stdbool.h>
#include <sys/types.h>

#include "core/robot.h"

struct guard {
    pid_t pid; /* 0: none */
    int pipe;
};

/* Starts the guard of a robot on an open line; `closes` is a descriptor that
 * is none of its business. Without a guard the run goes on. */
void guard_start(struct guard *g, struct frob_robot *robot, int64_t patience_ns, int closes);

/* To be called several times within the patience. */
void guard_hear(const struct guard *g);

void guard_end(struct guard *g);

#endif
