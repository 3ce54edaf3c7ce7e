/* truth.h -- what a simulator knows of a robot and the robot does not, for who looks on. */
#ifndef FROB_HOST_TRUTH_H
#define FROB_HOST_TRUTH_H

struct truth {
    double x_m, y_m, heading_rad; /* in the world */
    double touches;               /* 1: it touches a wall or another robot; else 0 */
};

#endif
