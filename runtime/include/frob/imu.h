/* frob/imu.h -- readings of an inertial measurement unit as part of a program's input.
 *
 * In the program's table, `console` has a control of the kind FROB_IMU for each unit that the
 * program uses. The label of such a control is the unit's name. */
#ifndef FROB_IMU_H
#define FROB_IMU_H

#include <frob/program.h>

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A reading, in the robot's axes: x ahead, y to the left, z up. If the device measures more often
 * than the program reads, rates and accelerations are the means of all measurements since the
 * previous reading. */
struct frob_imu {
    double rate_radps[3];        /* turn rate around each axis */
    double acceleration_mps2[3]; /* acceleration, including gravity: 9.81 upwards at rest */
    double heading_rad;          /* heading from a magnetometer; NaN if there is none */
    int64_t taken_ns;            /* time of the last measurement */
    uint32_t number;             /* number of the last measurement */
};

/* Sets the event for this instant to the reading and its age at the time `now_ns`. Sets no event if
 * `reading` is NULL. */
void frob_imu_give(const struct frob_control *imu, void *input, const struct frob_imu *reading,
                   int64_t now_ns);

#ifdef __cplusplus
}
#endif
#endif
