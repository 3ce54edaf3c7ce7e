/* scout/odometry.h -- where a Scout is and how fast, from its states.
 *
 * Positions are added up from differences, since their field wraps. The place
 * is kept from connection to connection; it is zero, looking along x, where the
 * first state found the robot. A packet's sum is a byte only, so now and then a
 * damaged state gets through: places that the robot cannot have reached since
 * the last state are refused, unless it says so again and again. Speeds are
 * measured over a fifth of a second: a step of the counters is 2.54 mm. */
#ifndef FROB_DRIVERS_SCOUT_ODOMETRY_H
#define FROB_DRIVERS_SCOUT_ODOMETRY_H

#include "drivers/scout/state.h"

#ifdef __cplusplus
extern "C" {
#endif

struct frob_scout_place {
    double x_m, y_m;
    double heading_rad; /* not reduced to a turn */
};

/* All zero at the start. */
struct frob_scout_odometry {
    bool known; /* the fields of the connection's last state: */
    int x, y, heading;
    int64_t taken_ns; /* when it came */
    unsigned refused; /* states, one after the other */
    double axes_rad;  /* from the axes of these fields to those of the place */
    struct frob_scout_place place, measured; /* now, and when the measurement of speeds began */
    int64_t measured_ns;
    double forward_m_s, turn_rad_s;
};

/* The next state is the first of a connection: the robot may have another
 * place for where it is. */
void frob_scout_odometry_reconnect(struct frob_scout_odometry *odometry);

/* Takes a state that arrived at `now_ns`; false if the robot cannot have
 * reached its place. */
bool frob_scout_odometry_add(struct frob_scout_odometry *odometry,
                             const struct frob_scout_state *state, int64_t now_ns);

#ifdef __cplusplus
}
#endif
#endif
