/* rover_odometry.h -- where a Rover is and how fast, from its encoders' counts.
 *
 * Counts wrap around, so ways are differences. The place is kept from connection
 * to connection. Lines have no check sum: counts that the robot cannot have made
 * since the last ones are refused, unless it says so again and again. */
#ifndef ROVER_ODOMETRY_H
#define ROVER_ODOMETRY_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* All zero at the start. */
struct rover_odometry {
    bool known; /* counts of this connection: */
    int32_t left, right;
    int64_t taken_ns;
    unsigned refused; /* counts, one after the other */
    double x_m, y_m, heading_rad;
    double left_m, right_m; /* the ways of the wheels since the measurement of speeds began */
    int64_t measured_ns;
    double left_m_s, right_m_s;
};

/* The next counts are the first of a connection: the board may have begun anew. */
void rover_odometry_reconnect(struct rover_odometry *odometry);

/* Takes counts that came at `now_ns`, of so many for each metre; false if they
 * are refused. */
bool rover_odometry_add(struct rover_odometry *odometry, int32_t left, int32_t right,
                        double counts_per_m, double separation_m, int64_t now_ns);

#ifdef __cplusplus
}
#endif
#endif
