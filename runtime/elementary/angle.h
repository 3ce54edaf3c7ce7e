/* Reduction of angles to quarter turns. Internal to the runtime; not installed. */
#ifndef FROB_ELEMENTARY_ANGLE_H
#define FROB_ELEMENTARY_ANGLE_H

#include <stdbool.h>

#include "double_double.h"

/* x = (quarter + 4 i) pi/2 + rest for some integer i. |rest| is at most slightly above pi/4, and
 * has about 100 bits after the binary point. */
struct angle {
    struct pair rest;
    unsigned quarter; /* 0 to 3 */
};

/* Reduces x, which must be finite. */
struct angle frob_reduce(double x);

/* The sine and the cosine of a remainder, to about 60 bits. The polynomials were computed by
 * Sollya,
 *   fpminimax((sin(sqrt(x))/sqrt(x)-1)/x, 6, [|D...|], [0; (pi/4)^2], relative)
 *   fpminimax((cos(sqrt(x))-1+x/2)/x^2, 5, [|D...|], [0; (pi/4)^2], relative)
 * with errors below 2^-60. */
static inline struct pair sine_of_rest(struct pair y)
{
    double const z = y.high * y.high;
    double const p = 0x1.111111111101fp-7 +
                     z * (-0x1.a01a019fe8de3p-13 +
                          z * (0x1.71de3a10d6dd4p-19 +
                               z * (-0x1.ae63f8fdc7108p-26 +
                                    z * (0x1.60e684b29aa41p-33 + z * -0x1.8db5a790f3403p-41))));
    double const cube = z * y.high;
    return sum_ordered(y.high, y.low * (1.0 - 0.5 * z) + cube * (-0x1.5555555555555p-3 + z * p));
}

static inline struct pair cosine_of_rest(struct pair y)
{
    struct pair const square = product(y.high, y.high);
    double const z = square.high;
    double const p = 0x1.5555555555555p-5 +
                     z * (-0x1.6c16c16c168cap-10 +
                          z * (0x1.a01a019f3838fp-16 +
                               z * (-0x1.27e4fa02e3bf8p-22 +
                                    z * (0x1.1eeb57d2ffc05p-29 + z * -0x1.907385311fb0bp-37))));
    struct pair const first = sum_ordered(1.0, -0.5 * z);
    return sum_ordered(first.high, first.low + (z * z * p - 0.5 * square.low - y.high * y.low));
}

#endif
