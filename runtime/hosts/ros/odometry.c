#include "odometry.h"

#include <math.h>

/* Maximum difference between 1 and the squared norm of a rotation's quaternion. */
#define ROUGHLY 0.02

bool ros_yaw_of(const double rotation[4], double *yaw_rad)
{
    const double x = rotation[0], y = rotation[1], z = rotation[2], w = rotation[3];
    *yaw_rad = atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z));
    return fabs(x * x + y * y + z * z + w * w - 1.0) <= ROUGHLY;
}

const char *ros_motion_of(const struct ros_odometry *o, struct ros_motion *motion)
{
    if (!isfinite(o->x_m) || !isfinite(o->y_m))
        return "its position is not a finite number";
    if (!isfinite(o->speed_m_s) || !isfinite(o->turning_rad_s))
        return "its speed is not a finite number";
    if (!ros_yaw_of(o->rotation, &motion->heading_rad))
        return "its orientation is not a quaternion of length 1";
    motion->x_m = o->x_m;
    motion->y_m = o->y_m;
    motion->speed_m_s = o->speed_m_s;
    motion->turning_rad_s = o->turning_rad_s;
    return NULL;
}
