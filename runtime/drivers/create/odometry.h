/* create/odometry.h -- the pose and speed of a Create, computed from its encoder counts.
 *
 * The counts wrap around, so the odometry adds up differences. A frame's checksum is a single byte,
 * so a damaged frame occasionally passes the check. Therefore the odometry rejects counts that the
 * robot cannot have reached since the last frame. After several consecutive rejections, it assumes
 * that the robot was restarted. It keeps the pose after a restart and between connections. */
#ifndef FROB_DRIVERS_CREATE_ODOMETRY_H
#define FROB_DRIVERS_CREATE_ODOMETRY_H

#include "drivers/create/sensors.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Value for the robot's standard wheels, with a diameter of 72 mm and 508.8 counts per turn.
 * libcreate and pycreate2 agree on these numbers. */
#define FROB_CREATE_METRES_PER_COUNT (3.14159265358979323846 * 0.072 / 508.8)

/* Initially all zero. */
struct frob_create_odometry {
    bool known;
    uint16_t left_counts, right_counts;
    int64_t taken_ns;       /* time at which the counts arrived */
    unsigned refused;       /* number of consecutive rejected frames */
    double x_m, y_m;        /* relative to the first pose, which faces along x */
    double heading_rad;     /* not reduced to a single turn */
    double left_m, right_m; /* distances that the wheels have travelled since measured_ns */
    int64_t measured_ns;    /* start time of the current speed measurement */
    double left_m_s, right_m_s;
};

/* Marks the next counts as the first of a connection. */
void frob_create_odometry_reconnect(struct frob_create_odometry *odometry);

/* Adds counts that arrived at `now_ns`. Returns false and rejects them if the robot cannot have
 * moved that far. */
bool frob_create_odometry_add(struct frob_create_odometry *odometry, uint16_t left_counts,
                              uint16_t right_counts, int64_t now_ns, double separation_m);

#ifdef __cplusplus
}
#endif
#endif
