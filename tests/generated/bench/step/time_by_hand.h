/* time_by_hand.h -- the language's rules for time, as a careful programmer would implement them:
 * dt is rounded to whole nanoseconds, halves to even; it is never negative or NaN, and at most 10^9 s. */
#ifndef TIME_BY_HAND_H
#define TIME_BY_HAND_H

#include <stdint.h>

/* Adding 2^52 leaves no bits for a fraction; larger numbers have no fraction. */
static inline double rounded_nanoseconds(double seconds)
{
    const double all = 4503599627370496.0;
    double ns;
    if (!(seconds > 0))
        return 0;
    if (seconds > 1e9)
        seconds = 1e9;
    ns = seconds * 1e9;
    return ns < all ? (ns + all) - all : ns;
}

static inline int64_t nanoseconds(double seconds)
{
    return (int64_t)rounded_nanoseconds(seconds);
}

static inline double whole_nanoseconds(double seconds)
{
    return rounded_nanoseconds(seconds) / 1e9;
}

#endif
