/* Inverse sine, cosine and tangent, and hypot, in single precision. */
#include <frob/elementary.h>
#include <math.h>

#include "single.h"

uint32_t frob_root_of_integer(uint64_t n)
{
    float const start = sqrtf((float)(uint32_t)(n >> 32)) * 65536.0f;
    uint32_t const root = start < 0x1.fffffep31f ? (uint32_t)start : 0xffffff00u;
    int64_t const rest = (int64_t)(n - (uint64_t)root * root);
    int64_t const mended = (int64_t)root + (int32_t)((float)rest / (2.0f * (float)root));
    return mended < INT64_C(0x100000000) ? (uint32_t)mended : 0xffffffffu;
}

/* Q60 */
#define HALF_PI INT64_C(0x1921fb54442d1847)
#define PI INT64_C(0x3243f6a8885a308d)

/* 1 - atan(q)/q as a function of z = q^2, which is below 1/16; z and the result are Q32. The
 * polynomial is near-minimax, from interpolation at Chebyshev points; its error is below 2^-36. */
static uint32_t less_than_slope(uint32_t z)
{
    return high(
        0x55555555u -
            high(0x33333181u - high(0x24916f16u - high(0x1c4b32e1u - high(0x1471945bu, z), z), z),
                 z),
        z);
}

/* The angle of (x, y), between 0 and pi/2, for positive x and y; if `behind`, pi minus that angle.
 * If the quotient is below 1/4, the polynomial yields the angle directly. Otherwise
 *
 *   atan(y/x) = atan(c) + atan((y - c x) / (x + c y)), with c = 1/2 or 1.
 *
 * If y > x, the angle is pi/2 minus the angle of (y, x). */
static float first_quadrant(bool negative, bool behind, struct scaled y, struct scaled x)
{
    bool const steep = y.e > x.e || (y.e == x.e && y.m > x.m);
    struct scaled const below = steep ? y : x;
    struct scaled const above = steep ? x : y;
    int const smaller = below.e - above.e;
    /* a and b are in the same units, so the quotient is a / b. */
    uint32_t const a = smaller < 4 ? above.m >> smaller : 0;
    uint32_t const b = below.m;
    int64_t angle; /* Q60 */
    if (a < b / 4) {
        struct scaled const q = above.m < b
                                    ? scaled_of(((uint64_t)above.m << 32) / b, -smaller - 32)
                                    : scaled_of(((uint64_t)above.m << 31) / b, -smaller - 31);
        int const drop = -q.e - 32; /* number of bits to drop for Q32 */
        uint32_t const of_32 = drop < 32 ? q.m >> drop : 0;
        uint32_t const m = q.m - high(q.m, less_than_slope(high(of_32, of_32)));
        if (!steep && !behind)
            return single_of(negative, scaled_of(m, q.e));
        angle = drop < 60 ? (int64_t)(((uint64_t)m << 28) >> drop) : 0;
    } else {
        bool const half = a < b / 4 * 3;
        int64_t const top = half ? 2 * (int64_t)a - b : (int64_t)a - b;
        int64_t const bottom = half ? 2 * (int64_t)b + a : (int64_t)b + a;
        int64_t const q = top * INT64_C(0x80000000) / bottom; /* Q31 */
        uint32_t const size = (uint32_t)(q < 0 ? -q : q) * 2; /* Q32 */
        int64_t const rest = (int64_t)(size - high(size, less_than_slope(high(size, size)))) << 28;
        angle = (half ? INT64_C(0x076b19c1586ed3da) : HALF_PI / 2) + (q < 0 ? -rest : rest);
    }
    if (steep)
        angle = HALF_PI - angle;
    if (behind)
        angle = PI - angle;
    return single_of(negative, scaled_of((uint64_t)angle, -60));
}

static const struct scaled one = { 0x80000000u, -31 };

float frob_atanf(float x)
{
    if (isnan(x))
        return NAN;
    if (fabsf(x) < 0x1p-13f)
        return x;
    if (isinf(x))
        return copysignf(0x1.921fb6p0f, x);
    return first_quadrant(signbit(x) != 0, false, scaled_of_single(x), one);
}

float frob_atan2f(float y, float x)
{
    bool const behind = signbit(x) != 0;
    if (isnan(x) || isnan(y))
        return NAN;
    if (isinf(x) && isinf(y))
        return copysignf(behind ? 0x1.2d97c8p1f : 0x1.921fb6p-1f, y);
    if (y == 0.0f || isinf(x))
        return copysignf(behind ? 0x1.921fb6p1f : 0.0f, y);
    if (x == 0.0f || isinf(y))
        return copysignf(0x1.921fb6p0f, y);
    /* The quotient may be subnormal or zero. */
    if (!behind && fabsf(y) < 0x1p-16f * x)
        return y / x;
    return first_quadrant(signbit(y) != 0, behind, scaled_of_single(y), scaled_of_single(x));
}

/* The square root of 1 - x^2, for 0 < x < 1. */
static struct scaled other_side(struct scaled x)
{
    int const drop = -2 * x.e - 64;
    uint64_t const square = drop < 64 ? ((uint64_t)x.m * x.m) >> drop : 0; /* Q64 */
    uint64_t n = UINT64_C(0) - square;
    struct scaled root;
    root.e = -32;
    if (square == 0)
        return one;
    while (n >> 62 == 0) {
        n <<= 2;
        root.e -= 1;
    }
    root.m = frob_root_of_integer(n);
    return root;
}

float frob_asinf(float x)
{
    float const size = fabsf(x);
    if (!(size <= 1.0f))
        return NAN;
    if (size < 0x1p-13f)
        return x;
    if (size == 1.0f)
        return copysignf(0x1.921fb6p0f, x);
    {
        struct scaled const y = scaled_of_single(x);
        return first_quadrant(signbit(x) != 0, false, y, other_side(y));
    }
}

float frob_acosf(float x)
{
    float const size = fabsf(x);
    if (!(size <= 1.0f))
        return NAN;
    if (size < 0x1p-30f)
        return 0x1.921fb6p0f;
    if (size == 1.0f)
        return signbit(x) ? 0x1.921fb6p1f : 0.0f;
    {
        struct scaled const side = scaled_of_single(x);
        return first_quadrant(false, signbit(x) != 0, other_side(side), side);
    }
}

float frob_hypotf(float x, float y)
{
    float const a = fabsf(x);
    float const b = fabsf(y);
    float const larger = a > b ? a : b;
    float const smaller = a > b ? b : a;
    if (isinf(x) || isinf(y))
        return INFINITY;
    if (isnan(x) || isnan(y))
        return NAN;
    if (smaller == 0.0f)
        return larger;
    {
        struct scaled const l = scaled_of_single(larger);
        struct scaled const s = scaled_of_single(smaller);
        int const drop = 2 * (l.e - s.e);
        uint64_t n; /* a quarter of the sum of squares, in units of 2^(2 l.e) */
        struct scaled root;
        if (drop > 32)
            return larger; /* the result is too small by less than 1/32 of a unit */
        n = ((uint64_t)l.m * l.m >> 2) + (((uint64_t)s.m * s.m >> 2) >> drop);
        root.e = l.e + 1;
        if (n >> 62 == 0) {
            n <<= 2;
            root.e -= 1;
        }
        root.m = frob_root_of_integer(n);
        return single_of(false, root);
    }
}
