/* truth.h -- the ground truth about a simulated robot, for viewers. */
#ifndef FROB_HOST_TRUTH_H
#define FROB_HOST_TRUTH_H

struct truth {
    double x_m, y_m, heading_rad; /* pose in the world */
    double touches;               /* 1: touched an object since the previous instant; else 0 */
};

#endif
