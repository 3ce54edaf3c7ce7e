#include <frob/elementary.h>
#include <math.h>

#include "double_double.h"

/* Computes the square root of the exact sum of squares, and corrects it by one step of Newton's
 * method with the exact remainder (C. F. Borges, "An improved algorithm for hypot(a, b)", 2019). */
double frob_hypot(double x, double y)
{
    double a = fabs(x);
    double b = fabs(y);
    if (isinf(a) || isinf(b))
        return INFINITY;
    if (isnan(a) || isnan(b))
        return NAN;
    if (a < b) {
        double const smaller = a;
        a = b;
        b = smaller;
    }
    if (b == 0.0)
        return a;

    /* Scales both, if necessary, so that their squares neither overflow nor underflow. Any bits
     * that b loses do not affect the result. */
    double up = 1.0;
    double down = 1.0;
    if (a > 0x1p+500) {
        up = 0x1p-600;
        down = 0x1p+600;
    } else if (b < 0x1p-450) {
        if (a > 0x1p-380)
            return a + b; /* b only affects the rounding */
        up = 0x1p+600;
        down = 0x1p-600;
    }
    a *= up;
    b *= up;
    if (a > 0x1p+60 * b)
        return (a + b) * down;

    struct pair const aa = product(a, a);
    struct pair const bb = product(b, b);
    struct pair const squares = sum_ordered(aa.high, bb.high);
    double const rest = squares.low + (aa.low + bb.low);
    double const root = sqrt(squares.high);
    struct pair const back = product(root, root);
    double const error = ((squares.high - back.high) - back.low) + rest;
    return (root + error / (2.0 * root)) * down;
}
