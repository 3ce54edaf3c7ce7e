#include <frob/elementary.h>
#include <math.h>

#include "angle.h"

static double sine_of(struct angle a)
{
    double const size =
        (a.quarter & 1u) != 0 ? cosine_of_rest(a.rest).high : sine_of_rest(a.rest).high;
    return (a.quarter & 2u) != 0 ? -size : size;
}

double frob_sin(double x)
{
    if (fabs(x) < 0x1p-27)
        return x; /* preserves the sign of zero */
    if (!isfinite(x))
        return NAN;
    return sine_of(frob_reduce(x));
}

double frob_cos(double x)
{
    if (!isfinite(x))
        return NAN;
    struct angle a = frob_reduce(x);
    a.quarter += 1;
    return sine_of(a);
}

double frob_tan(double x)
{
    if (fabs(x) < 0x1p-27)
        return x;
    if (!isfinite(x))
        return NAN;
    struct angle const a = frob_reduce(x);
    struct pair const s = sine_of_rest(a.rest);
    struct pair const c = cosine_of_rest(a.rest);
    return (a.quarter & 1u) != 0 ? -quotient(c, s).high : quotient(s, c).high;
}
