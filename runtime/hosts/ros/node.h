/* node.h -- the ROS 2 node, in a separate process: it receives the robot's messages, and publishes
 * the velocities that the supervisor sends.
 *
 * rcl starts threads, and the supervisor forks, so they must be in separate processes. A socket
 * connects them. When no process has the other end of the socket open, the node publishes zero
 * and ends. Until then, it ignores signals from the terminal. The guards (hosts/robot/guard.h)
 * also keep the socket open, and stop the robot through the node.
 *
 * The process has two threads. One waits for messages; the other publishes velocities without
 * waiting for the first. */
#ifndef FROB_HOST_ROS_NODE_H
#define FROB_HOST_ROS_NODE_H

#include <stdbool.h>

#include <frob/program.h>

struct node_options {
    const struct frob_program *program; /* its name is also the node's name, unless that is
                                         * remapped */
    int socket;                         /* socket to the supervisor */
    bool stamped;                       /* publish TwistStamped */
    bool use_sim_time;
    bool has_joystick;  /* whether a joystick operates the program's console */
    bool is_managed;    /* whether other nodes configure and activate it */
    const void *params; /* the program's parameter struct */
    int argc;           /* the arguments for rcl, which begin with the name of the program */
    char **argv;
};

/* Runs the node. Returns the exit status of the process. */
int node_run(const struct node_options *options);

#endif
