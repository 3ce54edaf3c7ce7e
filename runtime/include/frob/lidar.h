/* frob/lidar.h -- scans of a lidar as part of a program's input.
 *
 * In the program's table, `console` lists the lidars that the program uses, with the kind
 * FROB_LIDAR. The label of such a control is the lidar's name and the number of directions that the
 * program uses: "lidar 72". The host passes each scan in the form in which the device measured it,
 * and frob_lidar_give converts it to the program's directions. */
#ifndef FROB_LIDAR_H
#define FROB_LIDAR_H

#include <frob/program.h>

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* One scan of a device. Ray i has the bearing first_rad + i * step_rad: relative to the robot's
 * heading, positive to the left. step_rad is positive, and the rays cover at most one turn. */
struct frob_scan {
    /* Distances from the device. Infinity, or a distance above farthest_m, means that nothing is in
     * range. NaN, or a distance below nearest_m, means that the distance is unknown. */
    const double *ranges_m;
    size_t count;
    double first_rad, step_rad;
    double nearest_m, farthest_m; /* the device's range */
    double x_m, y_m;              /* the device's position, ahead of the robot's centre and to the
                                   * left of it */
    int64_t taken_ns;             /* time at which the device measured the scan */
    uint32_t number;              /* number of the scan; lost scans count too */
};

/* Returns the length of the lidar's name in a control's label; 0 if the control is not a lidar. */
size_t frob_lidar_label(const struct frob_control *control);

/* Sets the lidar's event for this instant to the scan and its age at the time `now_ns`. Sets no
 * event if `scan` is NULL.
 *
 * Direction k of n has the bearing k * 360 / n degrees, and covers the sector of 360 / n degrees
 * around it. Its distance is the smallest one measured by the rays in the sector and by those at
 * most step_rad / 2 away from its bearing. Therefore no object is lost if the device has more
 * rays than the program has directions, and no direction is empty if the device has fewer. */
void frob_lidar_give(const struct frob_control *lidar, void *input, const struct frob_scan *scan,
                     int64_t now_ns);

#ifdef __cplusplus
}
#endif
#endif
