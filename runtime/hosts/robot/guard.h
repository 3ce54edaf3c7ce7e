/* guard.h -- processes that stop the robot if the supervisor itself ends, hangs or is suspended.
 *
 * A guard also has the line open. It does nothing while it receives heartbeats from the supervisor.
 * If it receives none for longer than `patience_ns`, it sends the stop command ten times a second
 * until the supervisor is back. If the supervisor ends without ending the guard, the guard stops
 * the robot and ends.
 *
 * There are two guards, so that one remains if the supervisor and a guard are killed at the same
 * moment. The supervisor replaces a guard that has ended or hangs. */
#ifndef FROB_HOST_ROBOT_GUARD_H
#define FROB_HOST_ROBOT_GUARD_H

#include <stdbool.h>
#include <sys/types.h>

#include "core/robot.h"

enum { GUARDS = 2 };

struct guard {
    pid_t pid; /* 0: none */
    int pipe;
    int64_t awake_ns; /* time at which its pipe was last empty */
};

struct guards {
    struct guard each[GUARDS];
    struct frob_robot *robot; /* NULL: there is no session to guard */
    int64_t patience_ns;
    int64_t retry_ns; /* time of the next attempt after a failed start */
    int closes;
};

/* Starts the guards of a robot on an open line; `closes` is a descriptor that the guards close. If
 * a guard cannot be started, the run continues with a warning, and guards_hear tries again. */
void guards_start(struct guards *g, struct frob_robot *robot, int64_t patience_ns, int closes);

/* Sends a heartbeat to the guards; must be called several times per `patience_ns`. If a guard has
 * ended, or has read nothing for a second, replaces it and prints a line on standard error. */
void guards_hear(struct guards *g);

/* Ends the guards at the end of a session. */
void guards_end(struct guards *g);

#endif
