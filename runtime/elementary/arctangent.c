#include <frob/elementary.h>
#include <math.h>
#include <stdbool.h>

#include "double_double.h"

/* The angle of (x, y), between 0 and pi/2. Requires x >= 0 and y >= 0, not both 0, neither much
 * larger than 1, and the larger one not much smaller than 1.
 *
 * atan(y/x) = atan(c) + atan((y - c x) / (x + c y)), where c is one of 0, 1/2, 1, 2 and infinity,
 * so that the second term is at most atan(1/2)/2. The products c x and c y are exact. */
static struct pair first_quadrant(struct pair y, struct pair x)
{
    static const struct pair angles[5] = {
        { 0.0, 0.0 },
        { 0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56 },
        { 0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55 },
        { 0x1.1b6e192ebbe44p0, 0x1.b1b466a88828ep-54 },
        { 0x1.921fb54442d18p0, 0x1.1a62633145c07p-54 },
    };
    static const double factor[5] = { 0.0, 0.5, 1.0, 2.0, 0.0 };
    int i;
    if (y.high < 0x1.71076p-1 * x.high)
        i = y.high < 0x1.e377ap-3 * x.high ? 0 : 1;
    else if (y.high < 0x1.632e6p0 * x.high)
        i = 2;
    else
        i = y.high < 0x1.0f1bcp2 * x.high ? 3 : 4;

    struct pair above; /* y - c x */
    struct pair below; /* x + c y */
    if (i == 4) {
        above.high = -x.high;
        above.low = -x.low;
        below = y;
    } else {
        double const c = factor[i];
        above = sum(y.high, -c * x.high);
        above.low += y.low - c * x.low;
        below = sum(x.high, c * y.high);
        below.low += x.low + c * y.low;
    }
    struct pair const q = quotient(above, below);

    /* Sollya: fpminimax((atan(sqrt(x))/sqrt(x)-1)/x, 8, [|D...|],
             [0; tan(atan(1/2)/2)^2], relative); error below 2^-64 */
    double const z = q.high * q.high;
    double const p =
        -0x1.5555555555555p-2 +
        z * (0x1.99999999996efp-3 +
             z * (-0x1.249249245fc2fp-3 +
                  z * (0x1.c71c71904c449p-4 +
                       z * (-0x1.745d070e7f05dp-4 +
                            z * (0x1.3b10dad27e3d5p-4 +
                                 z * (-0x1.10c39c199503fp-4 +
                                      z * (0x1.d7f15d7fd140dp-5 + z * -0x1.5382285d1ee75p-5)))))));
    double const rest = q.high * z * p + q.low * (1.0 - z);
    struct pair const angle = sum(angles[i].high, q.high);
    return sum(angle.high, angle.low + (angles[i].low + rest));
}

static struct pair exactly(double x)
{
    struct pair const p = { x, 0.0 };
    return p;
}

/* pi - a */
static double supplement(struct pair a)
{
    struct pair const difference = sum(0x1.921fb54442d18p1, -a.high);
    return difference.high + (difference.low + (0x1.1a62633145c07p-53 - a.low));
}

double frob_atan(double x)
{
    if (isnan(x))
        return NAN;
    double const size = fabs(x);
    if (size < 0x1p-27)
        return x;
    double const angle =
        size > 0x1p60 ? 0x1.921fb54442d18p0 : first_quadrant(exactly(size), exactly(1.0)).high;
    return copysign(angle, x);
}

/* The angle of (x, y) for positive finite x and y. */
static struct pair angle_of(double y, double x)
{
    /* Scales both so that the larger one is close to 1. */
    double const up = fmax(x, y) > 1.0 ? 0x1p-500 : 0x1p+500;
    if (fmax(x, y) > 0x1p+400 || fmax(x, y) < 0x1p-400) {
        x *= up;
        y *= up;
    }
    return first_quadrant(exactly(y), exactly(x));
}

double frob_atan2(double y, double x)
{
    if (isnan(x) || isnan(y))
        return NAN;
    double a = fabs(y);
    double b = fabs(x);
    bool const behind = signbit(x) != 0;
    if (isinf(a) || isinf(b)) {
        double const angle = !isinf(b)   ? 0x1.921fb54442d18p0
                             : !isinf(a) ? 0.0
                                         : 0x1.921fb54442d18p-1;
        return copysign(behind ? supplement(exactly(angle)) : angle, y);
    }
    if (a == 0.0)
        return copysign(behind ? 0x1.921fb54442d18p1 : 0.0, y);
    if (b == 0.0)
        return copysign(0x1.921fb54442d18p0, y);
    if (a < 0x1p-60 * b) /* the quotient may be subnormal or zero */
        return copysign(behind ? 0x1.921fb54442d18p1 : a / b, y);
    if (b < 0x1p-60 * a)
        return copysign(0x1.921fb54442d18p0, y);
    struct pair const angle = angle_of(a, b);
    return copysign(behind ? supplement(angle) : angle.high, y);
}

/* The square root of 1 - x^2, for 0 <= x <= 1. */
static struct pair other_side(double x)
{
    struct pair const down = sum(1.0, -x);
    struct pair const up = sum(1.0, x);
    struct pair square = product(down.high, up.high);
    square.low += down.high * up.low + down.low * up.high;
    if (square.high == 0.0)
        return square;
    double const root = sqrt(square.high);
    struct pair const back = product(root, root);
    return sum_ordered(root, (((square.high - back.high) - back.low) + square.low) / (2.0 * root));
}

double frob_asin(double x)
{
    double const size = fabs(x);
    if (!(size <= 1.0))
        return NAN;
    if (size < 0x1p-27)
        return x;
    return copysign(first_quadrant(exactly(size), other_side(size)).high, x);
}

double frob_acos(double x)
{
    double const size = fabs(x);
    if (!(size <= 1.0))
        return NAN;
    struct pair const angle = first_quadrant(other_side(size), exactly(size));
    return signbit(x) ? supplement(angle) : angle.high;
}
