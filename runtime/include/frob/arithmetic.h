/* frob/arithmetic.h -- checks that floating-point arithmetic meets the requirements of compiled
 * programs.
 *
 * A program's meaning is fixed to the last bit: its numbers are IEEE 754 binary64, each operation
 * rounds once, to nearest, and NaN, infinities, subnormal numbers and the sign of zero are
 * significant. Some compiler options break these rules (-ffast-math and its suboptions,
 * -ffp-contract=fast), and so do some settings of a processor's control registers (rounding mode,
 * flush to zero). Any library in the process may have changed these registers.
 *
 * The checks are in a header rather than a C file, because their result is valid only for the
 * options with which they are compiled, and for the thread that calls them:
 *
 *   #include <frob/arithmetic.h>
 *   if (frob_arithmetic_faults() != 0)
 *       do not move
 *
 * The program's table for hosts (<frob/program.h>) contains a copy of this function that is
 * compiled with the program's options. Before a robot may move, hosts call both that copy and their
 * own. A call performs a few dozen operations, accesses only memory on the stack, and uses only
 * memcpy from the C library. */
#ifndef FROB_ARITHMETIC_H
#define FROB_ARITHMETIC_H

#include <float.h>
#include <stdint.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The faults that these functions detect, as bit flags. */
enum frob_arithmetic_fault {
    FROB_ARITHMETIC_FORMAT = 1,      /* double is not binary64 */
    FROB_ARITHMETIC_ROUNDING = 2,    /* does not round to the nearest number */
    FROB_ARITHMETIC_PRECISION = 4,   /* keeps more than 53 bits of a result */
    FROB_ARITHMETIC_CONTRACTION = 8, /* rounds a product and a sum only once */
    FROB_ARITHMETIC_ALGEBRA = 16,    /* reorders operations or replaces divisions */
    FROB_ARITHMETIC_SUBNORMAL = 32,  /* flushes subnormal numbers to zero */
    FROB_ARITHMETIC_SPECIAL = 64     /* mishandles NaN, infinities or -0.0 */
};

/* Returns the bits of x. Comparing bits does not rely on the arithmetic that is under test. */
static inline uint64_t frob_arithmetic_bits(double x)
{
    uint64_t bits = 0;
    memcpy(&bits, &x, sizeof x < sizeof bits ? sizeof x : sizeof bits);
    return bits;
}

static inline int frob_arithmetic_is(double x, double expected)
{
    return frob_arithmetic_bits(x) == frob_arithmetic_bits(expected);
}

/* Returns the faults that were found, or-ed together; 0 if there are none. */
static inline unsigned frob_arithmetic_faults(void)
{
    /* Volatile hides the values from the optimizer. */
    volatile double one_ = 1.0, half_ulp_ = DBL_EPSILON / 2.0, less_ = -1.0, zero_ = 0.0;
    volatile double three_ = 3.0, least_ = DBL_MIN, most_ = DBL_MAX;
    const double one = one_, half_ulp = half_ulp_, less = less_, zero = zero_;
    const double three = three_, least = least_, most = most_;
    unsigned faults = 0;

    /* Only binary64 represents 1 and -1/3 with these bits. */
    if (FLT_RADIX != 2 || DBL_MANT_DIG != 53 || DBL_MAX_EXP != 1024 || sizeof(double) != 8)
        return FROB_ARITHMETIC_FORMAT;
    if (frob_arithmetic_bits(one) != UINT64_C(0x3ff0000000000000) ||
        frob_arithmetic_bits(-0x1.5555555555555p-2) != UINT64_C(0xbfd5555555555555))
        return FROB_ARITHMETIC_FORMAT;
    {
        /* Ties round to even; three quarters of an ulp round away from zero. */
        const double tie = one + half_ulp, tie_below = less - half_ulp;
        const double past = one + 1.5 * half_ulp, past_below = less - 1.5 * half_ulp;
        if (!frob_arithmetic_is(tie, 1.0) || !frob_arithmetic_is(tie_below, -1.0) ||
            !frob_arithmetic_is(past, 1.0 + DBL_EPSILON) ||
            !frob_arithmetic_is(past_below, -1.0 - DBL_EPSILON))
            faults |= FROB_ARITHMETIC_ROUNDING;
    }
    {
        /* Rounding to 64 bits first turns `twice` into a tie, which then rounds to 1. A sum with
         * excess range does not overflow, so subtracting `most` leaves a finite `kept`. */
        const double twice = one + half_ulp * (one + half_ulp * 2.0);
        const double kept = (most + most_) - most;
        if (!frob_arithmetic_is(twice, 1.0 + DBL_EPSILON) ||
            frob_arithmetic_bits(kept) != UINT64_C(0x7ff0000000000000))
            faults |= FROB_ARITHMETIC_PRECISION;
    }
    {
        /* (1 + e)(1 - e) is 1 - e^2, which rounds to 1. Subtracting 1 from the unrounded product
         * leaves e^2. Each product is computed anew, because compilers fuse only a product that has
         * no other use. */
        volatile double up = 1.0 + 0x1p-30, down = 1.0 - 0x1p-30;
        const double from_product = up * down - one;
        const double product_from = one - up * down;
        const double product_to = less + up * down;
        if (!frob_arithmetic_is(from_product, 0.0) || !frob_arithmetic_is(product_from, 0.0) ||
            !frob_arithmetic_is(product_to, 0.0))
            faults |= FROB_ARITHMETIC_CONTRACTION;
    }
    {
        /* A bit that is lost in a sum must not be restored, and 3 / 10 must differ from 3 times
         * 0.1. */
        const double lost = (half_ulp + one) - one, tenth = three / 10.0;
        const double sum = (half_ulp + half_ulp) + one, other = half_ulp + (half_ulp + one);
        if (!frob_arithmetic_is(lost, 0.0) || !frob_arithmetic_is(tenth, 0.3) ||
            !frob_arithmetic_is(sum, 1.0 + DBL_EPSILON) || !frob_arithmetic_is(other, 1.0))
            faults |= FROB_ARITHMETIC_ALGEBRA;
    }
    {
        /* A subnormal result must be kept, and a subnormal operand must not be read as zero. */
        const double half = least * 0.5;
        volatile double kept = half;
        if (frob_arithmetic_bits(half) != UINT64_C(0x0008000000000000) ||
            !frob_arithmetic_is(kept * 2.0, DBL_MIN))
            faults |= FROB_ARITHMETIC_SUBNORMAL;
    }
    {
        const double endless = one / zero, none = zero / zero;
        const double negative = zero * less;
        const int ordered = none == none || none < one || none > one || !(none != none);
        if (ordered || !(endless > most) || !frob_arithmetic_is(negative + 0.0, 0.0) ||
            frob_arithmetic_bits(negative) != UINT64_C(0x8000000000000000) ||
            !frob_arithmetic_is(0.0 - zero, 0.0))
            faults |= FROB_ARITHMETIC_SPECIAL;
    }
    return faults;
}

/* Checks single precision in the same way, for programs that compute with floats: a processor may
 * have a separate unit for them, with its own settings. Faults that only compiler options can cause
 * are left to the double-precision checks. */
static inline unsigned frob_arithmetic_float_faults(void)
{
    volatile float one_ = 1.0f, half_ulp_ = FLT_EPSILON / 2.0f, less_ = -1.0f;
    volatile float least_ = FLT_MIN, most_ = FLT_MAX;
    const float one = one_, half_ulp = half_ulp_, less = less_, least = least_, most = most_;
    unsigned faults = 0;
    uint32_t bits = 0;

    if (FLT_MANT_DIG != 24 || FLT_MAX_EXP != 128 || sizeof(float) != sizeof bits)
        return FROB_ARITHMETIC_FORMAT;
    memcpy(&bits, &less, sizeof(float) < sizeof bits ? sizeof(float) : sizeof bits);
    if (bits != UINT32_C(0xbf800000))
        return FROB_ARITHMETIC_FORMAT;
    {
        volatile float tie = one + half_ulp, tie_below = less - half_ulp;
        volatile float past = one + 1.5f * half_ulp, past_below = less - 1.5f * half_ulp;
        if (tie != 1.0f || tie_below != -1.0f || past != 1.0f + FLT_EPSILON ||
            past_below != -1.0f - FLT_EPSILON)
            faults |= FROB_ARITHMETIC_ROUNDING;
    }
    {
        volatile float kept = (most + most_) - most;
        if (!(kept > FLT_MAX))
            faults |= FROB_ARITHMETIC_PRECISION;
    }
    {
        volatile float up = 1.0f + 0x1p-13f, down = 1.0f - 0x1p-13f;
        volatile float from_product = up * down - one;
        volatile float product_from = one - up * down;
        if (from_product != 0.0f || product_from != 0.0f)
            faults |= FROB_ARITHMETIC_CONTRACTION;
    }
    {
        volatile float half = least * 0.5f;
        const float kept = half;
        memcpy(&bits, &kept, sizeof(float) < sizeof bits ? sizeof(float) : sizeof bits);
        if (bits != UINT32_C(0x00400000) || half * 2.0f != FLT_MIN)
            faults |= FROB_ARITHMETIC_SUBNORMAL;
    }
    return faults;
}

/* Describes the faults and how to fix them, as the end of a sentence that starts with "the
 * arithmetic". If there are several faults, names the one that may have caused the others. Returns
 * an empty string for 0. */
static inline const char *frob_arithmetic_reason(unsigned faults)
{
    if ((faults & FROB_ARITHMETIC_FORMAT) != 0)
        return "uses a double that is not an IEEE 754 binary64";
    if ((faults & FROB_ARITHMETIC_ROUNDING) != 0)
        return "does not round to nearest: remove the code that sets another rounding mode";
    /* Excess precision also looks like contraction; -ffast-math can look like excess precision. */
    if ((faults & FROB_ARITHMETIC_PRECISION) != 0 && (faults & FROB_ARITHMETIC_SPECIAL) == 0)
        return "uses more than 53 bits of precision: compile for SSE2 or another unit for doubles";
    if ((faults & FROB_ARITHMETIC_CONTRACTION) != 0)
        return "rounds a product and a sum only once: compile with -ffp-contract=off";
    if ((faults & (FROB_ARITHMETIC_ALGEBRA | FROB_ARITHMETIC_SPECIAL)) != 0)
        return "treats floating-point numbers as real numbers: compile without -ffast-math and its "
               "suboptions";
    if ((faults & FROB_ARITHMETIC_SUBNORMAL) != 0)
        return "flushes small numbers to zero: compile and link without -ffast-math";
    return "";
}

#ifdef __cplusplus
}
#endif
#endif
