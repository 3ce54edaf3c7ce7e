/* scout/odometry.h -- the pose and speed of a Scout, computed from its state packets.
 *
 * The position fields wrap around, so the odometry adds up differences. In the first state, the
 * robot is at the origin and faces along x; later connections continue from the last pose. A
 * packet's checksum is a single byte, so a damaged state occasionally passes the check. Therefore
 * the odometry rejects positions that the robot cannot have reached since the last state, but at
 * most three in a row. Speeds are measured over a fifth of a second, because one count is as much
 * as 2.54 mm. */
#ifndef FROB_DRIVERS_SCOUT_ODOMETRY_H
#define FROB_DRIVERS_SCOUT_ODOMETRY_H

#include "drivers/scout/state.h"

#ifdef __cplusplus
extern "C" {
#endif

struct frob_scout_place {
    double x_m, y_m;
    double heading_rad; /* not reduced to a single turn */
};

/* Initially all zero. */
struct frob_scout_odometry {
    bool known; /* whether the next fields, which come from the last state, are valid */
    int x, y, heading;
    int64_t taken_ns; /* time at which that state arrived */
    unsigned refused; /* number of consecutive rejected states */
    double axes_rad;  /* angle from the axes of these fields to those of the pose */
    struct frob_scout_place place, measured; /* current pose, and the pose at measured_ns */
    int64_t measured_ns;
    double forward_m_s, turn_rad_s;
};

/* Marks the next state as the first of a connection: the robot may now report different coordinates
 * for the same place. */
void frob_scout_odometry_reconnect(struct frob_scout_odometry *odometry);

/* Adds a state that arrived at `now_ns`. Rejects it and returns false if the robot cannot have
 * reached the position that the state reports. */
bool frob_scout_odometry_add(struct frob_scout_odometry *odometry,
                             const struct frob_scout_state *state, int64_t now_ns);

#ifdef __cplusplus
}
#endif
#endif
