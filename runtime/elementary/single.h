/* What the functions of single precision share. Part of the runtime's own; not
 * installed.
 *
 * They compute with integers, for a small processor has no others that are quick and
 * exact: 32 bits hold a float's 24 and eight more, and a product of two such
 * numbers is one instruction. A result is rounded to a float once, at the end, so
 * that it is within a little more than half a unit in the last place, and has the
 * same bits on every machine.
 *
 * Qn in a comment: the integer stands for itself times 2^-n. */
#ifndef FROB_ELEMENTARY_SINGLE_H
#define FROB_ELEMENTARY_SINGLE_H

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/* m 2^e, positive, with the highest bit of m set. */
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

/* The higher half of the product. */
static inline uint32_t high(uint32_t a, uint32_t b)
{
    return (uint32_t)(((uint64_t)a * b) >> 32);
}

/* v 2^e; v is not zero. */
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

/* |x|, which is finite and not zero. */
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

/* The nearest float, ties to even; infinite beyond the range. */
static inline float single_of(bool negative, struct scaled s)
{
    uint32_t const sign = negative ? 0x80000000u : 0u;
    int const exponent = s.e + 158; /* as the format has it */
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
    /* A carry goes into the exponent, where it belongs. */
    if (exponent > 0)
        kept += ((uint64_t)(unsigned)exponent << 23) - 0x800000u;
    return single_of_bits(sign | (uint32_t)kept);
}

/* The square root of n, at least 2^62, to less than one unit: from sqrtf, which is
 * right to 23 bits, and one step of Newton's method. */
uint32_t frob_root_of_integer(uint64_t n);

/* A number and its fraction of 62 bits: the logarithm to base 2. */
struct logarithm {
    bool negative;
    uint32_t whole;
    uint64_t fraction; /* Q62 */
};

/* Of a positive finite number; its relative error is below 2^-35. */
struct logarithm frob_log2_of(struct scaled x);

/* 2^(+-t), t being Q32; below 2^41. */
float frob_power_of_two(bool negative_sign, bool negative, uint64_t t);

#endif
