/* drivers/wheels.h -- wheel speeds of a robot with a wheel on each side.
 *
 * The wheels are `separation_m` apart. A program's output commands the forward speed v of the
 * midpoint between them, and the turn rate omega, counter-clockwise. The left wheel then has
 * the speed v - omega * separation / 2, the right wheel v + omega * separation / 2. */
#ifndef FROB_DRIVERS_WHEELS_H
#define FROB_DRIVERS_WHEELS_H

#include <math.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Speeds in metres per second, positive forward. */
struct frob_wheels {
    double left, right;
};

/* Computes the wheel speeds. If one exceeds `most_m_s`, both are scaled down by the same factor, so
 * that the robot follows the same curve. */
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

/* Implements `most` in a driver's table, for wheels with a maximum speed of `most_m_s`. If i is 0,
 * returns the maximum forward speed without turning, in m/s; if i is 1, the maximum turn rate on
 * the spot, in rad/s. */
static inline double frob_wheels_most(size_t i, double separation_m, double most_m_s)
{
    return i == 0 ? most_m_s : 2.0 * most_m_s / separation_m;
}

#ifdef __cplusplus
}
#endif
#endif
