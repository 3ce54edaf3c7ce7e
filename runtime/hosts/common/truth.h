/* truth.h -- the ground truth about a simulated robot or a movable object, for viewers. */
#ifndef FROB_HOST_TRUTH_H
#define FROB_HOST_TRUTH_H

struct truth {
    double x_m, y_m, heading_rad; /* the pose in the world */
    /* For a robot, 1 if it has touched an object since the previous instant, otherwise 0. */
    double touches;
};

/* The value of `touches` for an object. The data of an instant contains first the robots and then
 * the objects: the boxes and then the balls, in the order of the world file. */
#define TRUTH_OBJECT 2.0

#endif
