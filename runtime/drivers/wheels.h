/* drivers/wheels.h -- speeds for a robot with a wheel on each side.
 *
 * The wheels stand `separation_m` apart, and the middle between them moves with
 * the speed of a program's output: v ahead, omega to the left. A wheel then has
 * v -+ omega * separation / 2. */
#ifndef FROB_DRIVERS_WHEELS_H
#define FROB_DRIVERS_WHEELS_H

#include <math.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Metres per second, ahead. */
struct frob_wheels {
    double left, right;
};

/* The wheels' speeds; those of more than `most_m_s` are lowered together, so
 * that the robot keeps to its curve. */
static inline struct frob_wheels frob_wheels_of(double forward_m_s, double turn_rad_s,
                                                double separation_m, double most_m_s)
{
    double across = 0.5 * turn_rad_s * separation_m;
    struct frob_wheels wheels = { forward_m_s - across, forward_m_s + across };
    double greatest = fmax(fabs(wheels.left), fabs(wheels.right));
    if (greatest > most_m_s) {
        wheels.left *= most_m_s / greatest;
        wheels.right *= most_m_s / greatest;
    }
    return wheels;
}

/* What wheels of `most_m_s` can do, as `most` of a driver's table: ahead without
 * a turn (i = 0, m/s), and turning on the spot (i = 1, rad/s). */
static inline double frob_wheels_most(size_t i, double separation_m, double most_m_s)
{
    return i == 0 ? most_m_s : 2.0 * most_m_s / separation_m;
}

#ifdef __cplusplus
}
#endif
#endif
