/* session.h -- starts and monitors the supervisor's connection to the robot, and restarts it when a
 * lost robot is back. */
#ifndef FROB_HOST_ROBOT_SESSION_H
#define FROB_HOST_ROBOT_SESSION_H

#include "run.h"

/* Starts a session on the newly opened line. */
void session_begin(struct run *s);

/* Reads the data that the robot has sent. If the robot refuses to be driven, does not answer, or is
 * lost for too long, ends the run. */
void session_look_after(struct run *s);

bool session_is_ready(const struct run *s);

/* Stops the robot, if the line is open. */
void session_halt(struct run *s);

#endif
