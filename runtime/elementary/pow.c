#include <frob/elementary.h>
#include <stdbool.h>

#include "exp_kernel.h"
#include "log_kernel.h"

static bool is_integer(double y)
{
    return y == floor(y); /* floor is exact on every machine */
}

static bool is_odd(double y)
{
    return is_integer(y) && fabs(y) < 0x1p53 && !is_integer(0.5 * y);
}

/* x to the power y = exp(y log(x)), for 0 < x < inf, x != 1, and a finite y. */
static double power_of_positive(double x, double y)
{
    struct pair const l = log_pair(x);
    /* Beyond these limits the result is infinite, zero or one for every x, and the exact product
     * would overflow or underflow. */
    if (fabs(y) > 0x1p70)
        return (y > 0.0) == (x > 1.0) ? INFINITY : 0.0;
    if (fabs(y) < 0x1p-70)
        return 1.0;
    struct pair exponent = product(l.high, y);
    exponent.low += l.low * y;
    return exp_of_pair(exponent);
}

double frob_pow(double x, double y)
{
    if (y == 0.0 || x == 1.0)
        return 1.0;
    if (isnan(x) || isnan(y))
        return NAN;
    double const size = fabs(x);
    double const sign = signbit(x) && is_odd(y) ? -1.0 : 1.0;
    if (size == 0.0)
        return sign * (y > 0.0 ? 0.0 : INFINITY);
    if (isinf(y)) {
        if (size == 1.0)
            return 1.0;
        return (y > 0.0) == (size > 1.0) ? INFINITY : 0.0;
    }
    if (isinf(size))
        return sign * (y > 0.0 ? INFINITY : 0.0);
    if (x < 0.0 && !is_integer(y))
        return NAN;
    if (size == 1.0)
        return sign;
    return sign * power_of_positive(size, y);
}
