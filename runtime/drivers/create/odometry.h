/* create/odometry.h -- where a Create is and how fast, from its encoders.
 *
 * The counts wrap, so differences are added up. A frame's sum is a byte only,
 * so now and then a damaged frame gets through: counts that the robot cannot
 * have reached since the last frame are refused. After a few of them the robot
 * has been restarted; its place is kept, as it is from connection to connection. */
#ifndef FROB_DRIVERS_CREATE_ODOMETRY_H
#define FROB_DRIVERS_CREATE_ODOMETRY_H

#include "drivers/create/sensors.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Of the robot's wheels; libcreate and pycreate2 agree: 508.8 counts a turn of
 * a wheel of 72 mm. */
#define FROB_CREATE_METRES_PER_COUNT (3.14159265358979323846 * 0.072 / 508.8)

/* All zero at the start. */
struct frob_create_odometry {
    bool known;
    uint16_t left_counts, right_counts;
    int64_t taken_ns;       /* when they were read */
    unsigned refused;       /* frames, one after the other */
    double x_m, y_m;        /* from where the robot was first, which looked along x */
    double heading_rad;     /* not reduced to a turn */
    double left_m, right_m; /* ways of the wheels since the measurement of speeds, */
    int64_t measured_ns;    /* which began here */
    double left_m_s, right_m_s;
};

/* The next counts are the first of a connection. */
void frob_create_odometry_reconnect(struct frob_create_odometry *odometry);

/* Takes counts that arrived at `now_ns`; false if the robot cannot have
 * reached them. */
bool frob_create_odometry_add(struct frob_create_odometry *odometry, uint16_t left_counts,
                              uint16_t right_counts, int64_t now_ns, double separation_m);

#ifdef __cplusplus
}
#endif
#endif
