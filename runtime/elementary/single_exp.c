/* exp, log and pow in single precision. */
#include <frob/elementary.h>
#include <math.h>

#include "single.h"

/* 2^f - 1; f and the result are Q32. The polynomial approximates (2^f - 1)/f. It is near-minimax,
 * from interpolation at Chebyshev points; its error is below 2^-31. */
static uint32_t power_less_one(uint32_t f)
{
    static const uint32_t c[7] = { 0xb17217f9u, 0x3d7f7ba6u, 0x0e3589f8u, 0x02763464u,
                                   0x0057bf1au, 0x00099317u, 0x00015bd3u };
    uint32_t p = c[6];
    for (int i = 5; i >= 0; --i)
        p = c[i] + high(p, f);
    return high(p, f);
}

float frob_power_of_two(bool negative_sign, bool negative, uint64_t t)
{
    int const whole = (int)(t >> 32);
    uint32_t const fraction = (uint32_t)t;
    struct scaled s;
    if (!negative) {
        s.m = 0x80000000u | (power_less_one(fraction) >> 1);
        s.e = whole - 31;
    } else if (fraction == 0) {
        s.m = 0x80000000u;
        s.e = -whole - 31;
    } else {
        s.m = 0x80000000u | (power_less_one(0u - fraction) >> 1);
        s.e = -whole - 32;
    }
    return single_of(negative_sign, s);
}

float frob_expf(float x)
{
    if (isnan(x))
        return NAN;
    if (x > 89.0f)
        return INFINITY;
    if (x < -104.0f)
        return 0.0f;
    if (fabsf(x) < 0x1p-26f)
        return 1.0f;
    {
        struct scaled const s = scaled_of_single(x);
        /* multiplies by log2(e), Q31 with 32 additional bits */
        uint64_t const product = (uint64_t)s.m * 0xb8aa3b29u + high(s.m, 0x5c17f0bcu);
        return frob_power_of_two(false, x < 0.0f, product >> (-s.e - 1));
    }
}

/* Table-driven, after P. T. P. Tang, "Table-driven implementation of the logarithm function in IEEE
 * floating-point arithmetic", ACM TOMS 16 (1990): x = 2^k m. Given a c with few bits that is close
 * to 1/m, log2(x) = k - log2(c) + log2(1 + r), where r = m c - 1. */
struct logarithm frob_log2_of(struct scaled x)
{
    /* For each value of the five leading bits of m: 512 c, and -log2(c) as Q62. From the 15th
     * interval on, m is halved, so that c = 1 at both ends of the table, which avoids cancellation
     * on both sides of x = 1. */
    static const struct {
        uint16_t c;
        int64_t minus_log;
    } table[32] = {
        { 512, 0 },
        { 489, INT64_C(0x043e698d198eb733) },
        { 475, INT64_C(0x06ed040be494e4f2) },
        { 462, INT64_C(0x097cf196adfee84d) },
        { 449, INT64_C(0x0c1f98266e2d535c) },
        { 437, INT64_C(0x0e9feaa1d256ae3d) },
        { 426, INT64_C(0x10fa848044b35108) },
        { 415, INT64_C(0x1364e2511cc820cf) },
        { 405, INT64_C(0x15a56d7a370ded62) },
        { 395, INT64_C(0x17f462e58e168828) },
        { 386, INT64_C(0x1a152f142981b3d8) },
        { 377, INT64_C(0x1c42d5c4c688b3cf) },
        { 368, INT64_C(0x1e7df5fe538ab34f) },
        { 360, INT64_C(0x20857a9734f93132) },
        { 352, -INT64_C(0x1d6753e032ea0efe) },
        { 345, -INT64_C(0x1b8c88dbf8867997) },
        { 338, -INT64_C(0x19a802391e232f35) },
        { 331, -INT64_C(0x17b957ac51aac457) },
        { 324, -INT64_C(0x15c01a39fbd687a0) },
        { 318, -INT64_C(0x1406463b1b044976) },
        { 312, -INT64_C(0x124407ab0e073982) },
        { 306, -INT64_C(0x10790adbb030096f) },
        { 301, -INT64_C(0x0ef39ff1d8a40771) },
        { 295, -INT64_C(0x0d17b191905c3565) },
        { 290, -INT64_C(0x0b83a16a77813f95) },
        { 285, -INT64_C(0x09e88a36cd4531f8) },
        { 280, -INT64_C(0x08462c466d3cf1cb) },
        { 275, -INT64_C(0x069c4477cd2124fb) },
        { 271, -INT64_C(0x0541ee0d80ceedb5) },
        { 266, -INT64_C(0x0389bf5721556bdf) },
        { 262, -INT64_C(0x02239a3aa266825e) },
        { 256, 0 },
    };
    /* (log2(1 + r) / r - log2(e)) / r as Q31: near-minimax, from interpolation at Chebyshev points;
     * error below 2^-37. */
    static const int32_t q[6] = { -1549082005, 1032721336, -774540794,
                                  619632617,   -516928458, 443099571 };
    int64_t const unit = INT64_C(0x100000000); /* 1 in Q32 */
    uint32_t const i = (x.m >> 26) & 31u;
    int32_t k = x.e + 31 + (i >= 14 ? 1 : 0);
    /* This is exact, because m has 24 bits: Q40, then Q32. */
    int64_t const r = ((int64_t)x.m * table[i].c - (INT64_C(1) << 40)) / 256;
    int32_t p = q[5];
    int64_t slope; /* log2(1 + r) / r, Q62 */
    int64_t fraction;
    struct logarithm l;
    for (int j = 4; j >= 0; --j)
        p = q[j] + (int32_t)(p * r / unit);
    slope = INT64_C(0x5c551d94ae0bf85e) + r * p / 2;
    fraction = table[i].minus_log + r * (slope / unit) + r * (slope % unit) / unit;

    l.negative = k < 0 || (k == 0 && fraction < 0);
    if (l.negative) {
        k = -k;
        fraction = -fraction;
    }
    if (fraction < 0) {
        fraction += INT64_C(1) << 62;
        --k;
    }
    l.whole = (uint32_t)k;
    l.fraction = (uint64_t)fraction;
    return l;
}

float frob_logf(float x)
{
    if (isnan(x) || x < 0.0f)
        return NAN;
    if (x == 0.0f)
        return -INFINITY;
    if (isinf(x))
        return INFINITY;
    if (x == 1.0f)
        return 0.0f;
    {
        struct logarithm const l = frob_log2_of(scaled_of_single(x));
        struct scaled s = l.whole == 0 ? scaled_of(l.fraction, -62)
                                       : scaled_of((uint64_t)l.whole << 56 | l.fraction >> 6, -56);
        /* multiply by log(2) */
        s = scaled_of((uint64_t)s.m * 0xb17217f8u, s.e - 32);
        return single_of(l.negative, s);
    }
}

static bool is_integer(float y)
{
    return y == floorf(y); /* floor is exact on every machine */
}

static bool is_odd(float y)
{
    return is_integer(y) && fabsf(y) < 0x1p24f && !is_integer(0.5f * y);
}

/* x^y = 2^(y log2(x)), for 0 < x < inf, x != 1, and a finite y other than 0. */
static float power_of_positive(bool negative_sign, float x, float y)
{
    struct logarithm const l = frob_log2_of(scaled_of_single(x));
    bool const negative = l.negative != (y < 0.0f);
    float const beyond =
        negative_sign ? (negative ? -0.0f : -INFINITY) : (negative ? 0.0f : INFINITY);
    struct scaled const s = scaled_of_single(y);
    int const shift = -s.e;
    /* |y| times the logarithm is (above 2^32 + below) 2^(-32 - shift) */
    uint64_t const above = (uint64_t)s.m * l.whole;
    uint64_t const below =
        (uint64_t)s.m * (uint32_t)(l.fraction >> 30) + high(s.m, (uint32_t)(l.fraction << 2));
    uint64_t t; /* Q32 */
    if (shift < 0)
        return beyond;
    if (shift >= 96)
        return negative_sign ? -1.0f : 1.0f;
    if (shift >= 32) {
        t = (above + (below >> 32)) >> (shift - 32);
    } else {
        if (above >> shift >= 256 || below >> shift >= UINT64_C(0x10000000000))
            return beyond;
        t = (above << (32 - shift)) + (below >> shift);
    }
    if (t >> 32 >= 160)
        return beyond;
    return frob_power_of_two(negative_sign, negative, t);
}

float frob_powf(float x, float y)
{
    if (y == 0.0f || x == 1.0f)
        return 1.0f;
    if (isnan(x) || isnan(y))
        return NAN;
    {
        float const size = fabsf(x);
        bool const negative = signbit(x) && is_odd(y);
        float const sign = negative ? -1.0f : 1.0f;
        if (size == 0.0f)
            return sign * (y > 0.0f ? 0.0f : INFINITY);
        if (isinf(y)) {
            if (size == 1.0f)
                return 1.0f;
            return (y > 0.0f) == (size > 1.0f) ? INFINITY : 0.0f;
        }
        if (isinf(size))
            return sign * (y > 0.0f ? INFINITY : 0.0f);
        if (x < 0.0f && !is_integer(y))
            return NAN;
        if (size == 1.0f)
            return sign;
        return power_of_positive(negative, size, y);
    }
}
