/* Shared by the single-precision functions. Internal to the runtime; not installed.
 *
 * These functions use integer arithmetic, because no other is both fast and exact on a small
 * processor. A 32-bit integer has room for a float's 24 bits and eight more, and one instruction
 * multiplies two such integers. A result is rounded to a float once, at the end, so its error is
 * only slightly more than half a unit in the last place, and its bits are the same on every
 * machine.
 *
 * "Qn" in a comment means that an integer represents its value times 2^-n. */
#ifndef FROB_ELEMENTARY_SINGLE_H
#define FROB_ELEMENTARY_SINGLE_H

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/* The positive number m 2^e; the highest bit of m is set. */
struct scaled {
    uint32_t m;
    int e;
};

static inline uint32_t bits_of_single(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static inline float single_of_bits(uint32_t bits)
{
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* The upper 32 bits of the product. */
static inline uint32_t high(uint32_t a, uint32_t b)
{
    return (uint32_t)(((uint64_t)a * b) >> 32);
}

/* v 2^e; v must not be zero. */
static inline struct scaled scaled_of(uint64_t v, int e)
{
    struct scaled s;
    int k = 32;
    while (k > 0) {
        if (v >> (64 - k) == 0) {
            v <<= k;
            e -= k;
        }
        k /= 2;
    }
    s.m = (uint32_t)(v >> 32);
    s.e = e + 32;
    return s;
}

/* |x|; x must be finite and not zero. */
static inline struct scaled scaled_of_single(float x)
{
    uint32_t const bits = bits_of_single(x) & 0x7fffffffu;
    struct scaled s;
    if (bits < 0x00800000u)
        return scaled_of(bits, -149);
    s.m = (bits << 8) | 0x80000000u;
    s.e = (int)(bits >> 23) - 158;
    return s;
}

/* Rounds to the nearest float, ties to even; infinite if out of range. */
static inline float single_of(bool negative, struct scaled s)
{
    uint32_t const sign = negative ? 0x80000000u : 0u;
    int const exponent = s.e + 158; /* biased exponent */
    int const drop = exponent > 0 ? 8 : 9 - exponent;
    uint64_t const wide = (uint64_t)s.m;
    uint64_t kept;
    uint64_t rest;
    if (exponent >= 255)
        return single_of_bits(sign | 0x7f800000u);
    if (drop > 33)
        return single_of_bits(sign);
    kept = wide >> drop;
    rest = wide - (kept << drop);
    if (rest > (UINT64_C(1) << drop) / 2 || (rest == (UINT64_C(1) << drop) / 2 && (kept & 1u) != 0))
        ++kept;
    /* A carry out of the significand correctly increments the exponent. */
    if (exponent > 0)
        kept += ((uint64_t)(unsigned)exponent << 23) - 0x800000u;
    return single_of_bits(sign | (uint32_t)kept);
}

/* The square root of n, which is at least 2^62, with an error below one unit. It is computed with
 * sqrtf, which is accurate to 23 bits, followed by one step of Newton's method. */
uint32_t frob_root_of_integer(uint64_t n);

/* A logarithm to base 2: an integer, and a fraction of 62 bits. */
struct logarithm {
    bool negative;
    uint32_t whole;
    uint64_t fraction; /* Q62 */
};

/* The base-2 logarithm of a positive finite number, with a relative error below 2^-35. */
struct logarithm frob_log2_of(struct scaled x);

/* 2^t, or 2^-t if `negative`; with a minus sign if `negative_sign`. t is Q32 and below 2^41. */
float frob_power_of_two(bool negative_sign, bool negative, uint64_t t);

#endif
