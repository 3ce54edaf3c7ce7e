/* rover_odometry.h -- a Rover's pose and speed, computed from its encoder counts.
 *
 * Counts wrap around, so only their differences are used. The pose survives reconnecting. The
 * protocol has no checksum, so the odometry refuses counts that the robot cannot have reached since
 * the last accepted ones. If such counts keep coming, it restarts from them. */
#ifndef ROVER_ODOMETRY_H
#define ROVER_ODOMETRY_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Initialize with zeros. */
struct rover_odometry {
    bool known; /* whether these counts are from this connection: */
    int32_t left, right;
    int64_t taken_ns;
    unsigned refused; /* number of consecutive refused counts */
    double x_m, y_m, heading_rad;
    double left_m, right_m; /* distances driven since the speed measurement began */
    int64_t measured_ns;
    double left_m_s, right_m_s;
};

/* Call this before the first counts of a connection: the board may have restarted its counters. */
void rover_odometry_reconnect(struct rover_odometry *odometry);

/* Adds the counts that arrived at `now_ns`. Returns false if it refuses them. */
bool rover_odometry_add(struct rover_odometry *odometry, int32_t left, int32_t right,
                        double counts_per_m, double separation_m, int64_t now_ns);

#ifdef __cplusplus
}
#endif
#endif
