/* Sine, cosine and tangent in single precision. */
#include <frob/elementary.h>
#include <math.h>

#include "single.h"

/* An angle as a number of quarter turns and a remainder; |rest| is at most slightly above pi/4. */
struct angle {
    bool negative; /* sign of the remainder */
    struct scaled rest;
    unsigned quarter; /* 0 to 3 */
};

/* The bits of 2/pi after the binary point, preceded by 64 zeros. */
static const uint32_t two_over_pi[9] = { 0x00000000u, 0x00000000u, 0xa2f9836eu,
                                         0x4e441529u, 0xfc2757d1u, 0xf534ddc0u,
                                         0xdb629599u, 0x3c439041u, 0xfe5163abu };

/* Reduces x: multiplies its significand by the bits of 2/pi that matter modulo 4, as a 96-bit
 * integer (M. Payne and R. Hanek, "Radian reduction for trigonometric functions", SIGNUM Newsletter
 * 18, 1983). The distance of a float from a multiple of pi/2 is never less than 2^-30, so enough
 * bits of the remainder are left. */
static struct angle angle_of(float x)
{
    struct scaled const s = scaled_of_single(x);
    struct angle a;
    a.negative = signbit(x) != 0;
    a.rest = s;
    a.quarter = 0;
    if (fabsf(x) < 0x1.921fb6p-1f)
        return a; /* pi/4 */
    {
        /* 96 bits of 2/pi, starting with the bit of weight 2^(1 - e), most significant word first.
         * The bits before it contribute only multiples of 4 to the product. */
        int const first = s.e - 2 + 64;
        int const word = first / 32;
        int const shift = first % 32;
        uint32_t window[3];
        uint64_t low;
        uint64_t middle;
        uint32_t top;
        uint64_t rest; /* fraction of a quarter turn, Q64 */
        for (int i = 0; i < 3; ++i) {
            uint64_t const two = (uint64_t)two_over_pi[word + i] << 32 | two_over_pi[word + i + 1];
            window[i] = (uint32_t)((two << shift) >> 32);
        }
        low = (uint64_t)s.m * window[2];
        middle = (uint64_t)s.m * window[1] + (low >> 32);
        top = s.m * window[0] + (uint32_t)(middle >> 32);
        a.quarter = top >> 30;
        rest = (uint64_t)(top << 2 | (uint32_t)middle >> 30) << 32 |
               (uint32_t)((uint32_t)middle << 2 | (uint32_t)low >> 30);
        if (rest >> 63 != 0) {
            rest = UINT64_C(0) - rest;
            a.quarter += 1;
            a.negative = !a.negative;
        }
        if (signbit(x))
            a.quarter = 0u - a.quarter;
        a.quarter &= 3u;
        a.rest = scaled_of(rest, -64);
        a.rest = scaled_of((uint64_t)a.rest.m * 0xc90fdaa2u, a.rest.e - 31); /* pi/2, Q31 */
        return a;
    }
}

/* The square of a remainder, Q32. */
static uint32_t square_of(struct scaled rest)
{
    int const drop = -rest.e - 32; /* number of bits to drop for Q32 */
    uint32_t const y = drop < 32 ? rest.m >> drop : 0;
    return high(y, y);
}

/* Near-minimax polynomials in z, the square of the remainder y, from interpolation at Chebyshev
 * points. The error is below 2^-44 for (1 - sin(y)/y)/z, and below 2^-41 for (1 - cos(y))/z. */
static struct scaled sine_of_rest(struct scaled rest)
{
    uint32_t const z = square_of(rest);
    uint32_t const p =
        0x2aaaaaabu -
        high(0x02222222u - high(0x000d00d0u - high(0x00002e3bu - high(0x0000006bu, z), z), z), z);
    return scaled_of((uint64_t)rest.m - high(rest.m, high(p, z)), rest.e);
}

static struct scaled cosine_of_rest(struct scaled rest)
{
    uint32_t const z = square_of(rest);
    uint32_t const p =
        0x80000000u -
        high(0x0aaaaaabu - high(0x005b05afu - high(0x0001a013u - high(0x00000492u, z), z), z), z);
    return scaled_of(UINT64_C(0x100000000) - high(p, z), -32);
}

/* The sine of an angle. If the number of quarter turns is odd, uses the cosine of the remainder
 * instead of its sine. Two quarter turns change the sign. */
static float sine_of(struct angle a)
{
    bool const is_cosine = (a.quarter & 1u) != 0;
    bool const below = (a.quarter & 2u) != 0;
    if (is_cosine)
        return single_of(below, cosine_of_rest(a.rest));
    return single_of(below != a.negative, sine_of_rest(a.rest));
}

float frob_sinf(float x)
{
    if (fabsf(x) < 0x1p-13f)
        return x; /* preserves the sign of zero */
    if (!isfinite(x))
        return NAN;
    return sine_of(angle_of(x));
}

float frob_cosf(float x)
{
    if (fabsf(x) < 0x1p-13f)
        return 1.0f;
    if (!isfinite(x))
        return NAN;
    {
        struct angle a = angle_of(x);
        a.quarter += 1;
        return sine_of(a);
    }
}

float frob_tanf(float x)
{
    if (fabsf(x) < 0x1p-13f)
        return x;
    if (!isfinite(x))
        return NAN;
    {
        struct angle const a = angle_of(x);
        struct scaled const s = sine_of_rest(a.rest);
        struct scaled const c = cosine_of_rest(a.rest);
        bool const turned = (a.quarter & 1u) != 0;
        struct scaled const above = turned ? c : s;
        struct scaled const below = turned ? s : c;
        return single_of(a.negative != turned,
                         scaled_of(((uint64_t)above.m << 31) / below.m, above.e - below.e - 31));
    }
}
