/* Functions for generated C code: integers that wrap around, total division, conversions that
 * saturate, minimum and maximum that propagate NaN, and time in whole nanoseconds
 * (docs/language.md, "Numbers are total" and "Time").
 *
 * Functions whose names end in f take floats, as in <math.h>, for programs in single precision.
 * Everything is static inline, so functions that a program does not call cost nothing. No function
 * keeps state or causes a trap, and the only parts of the C library that they use are <math.h> and
 * memcpy.
 *
 * frobc reads this header too: `frobc compile --standalone` copies the definitions that a program
 * needs into the generated file, and generated code avoids the names defined here. frobc splits
 * this file at blank lines, so a definition must not contain a blank line. */
#ifndef FROB_STEP_H
#define FROB_STEP_H

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include <frob/elementary.h>

/* Generated code defines FROB_SINGLE if all its numbers are floats. */
#if !defined(FROB_SINGLE) && defined(DBL_MANT_DIG) && DBL_MANT_DIG != 53
#error "this processor has no IEEE doubles: compile the program with `frobc compile --real float`"
#endif

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ != 0) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#error "the program needs IEEE 754 arithmetic: compile without -ffast-math and its suboptions"
#endif

#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0
#error "the program needs IEEE 754 arithmetic: FLT_EVAL_METHOD must be 0 (x86: -msse2 -mfpmath=sse)"
#endif

/* ---- Compilers */

/* gcc 11 to 13 for aarch64 read a struct too early if two structs of different types share a stack
 * slot, unless strict aliasing is off (tests/generated/matrix/shared_stack.c is a complete
 * example). An attribute of the structs does not help, because they are variables, not pointers.
 * The pragma is limited to aarch64, because it prevents link-time optimization from inlining a
 * function with it into a caller without it. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__aarch64__)
#pragma GCC optimize("no-strict-aliasing")
#endif

/* Marks a condition that should compile to a branch, which the processor can predict. A conditional
 * select instead would make each step wait for the result of the previous one. */
#ifdef __GNUC__
#define FROB_BRANCH(condition) (__builtin_expect((condition), 0) != 0)
#else
#define FROB_BRANCH(condition) (condition)
#endif

/* ---- Truth values */

/* a && b and a || b, for operands that would make a C compiler warn that the result is constant. */
static inline bool frob_both(bool a, bool b)
{
    return a && b;
}

static inline bool frob_either(bool a, bool b)
{
    return a || b;
}

/* ---- Integers */

/* Interprets a 32-bit number as signed, in two's complement. */
static inline int32_t frob_wrap(uint32_t u)
{
    const uint32_t above = u - 0x80000000u;
    return u <= 0x7fffffffu ? (int32_t)u : (int32_t)above + INT32_MIN;
}

static inline int32_t frob_int_add(int32_t a, int32_t b)
{
    return frob_wrap((uint32_t)a + (uint32_t)b);
}

static inline int32_t frob_int_sub(int32_t a, int32_t b)
{
    return frob_wrap((uint32_t)a - (uint32_t)b);
}

static inline int32_t frob_int_mul(int32_t a, int32_t b)
{
    return frob_wrap((uint32_t)a * (uint32_t)b);
}

static inline int32_t frob_int_neg(int32_t a)
{
    return frob_wrap(0u - (uint32_t)a);
}

/* The least integer is its own absolute value, because the result wraps around. */
static inline int32_t frob_int_abs(int32_t a)
{
    return a < 0 ? frob_int_neg(a) : a;
}

static inline int32_t frob_int_signum(int32_t a)
{
    return a > 0 ? 1 : a < 0 ? -1 : 0;
}

static inline int32_t frob_int_min(int32_t a, int32_t b)
{
    return b < a ? b : a;
}

static inline int32_t frob_int_max(int32_t a, int32_t b)
{
    return b > a ? b : a;
}

/* Rounds towards minus infinity; division by 0 returns 0. */
static inline int32_t frob_int_div(int32_t a, int32_t b)
{
    if (b == 0) {
        return 0;
    }
    if (b == -1) {
        return frob_int_neg(a);
    }
    return a / b - (a % b != 0 && (a < 0) != (b < 0) ? 1 : 0);
}

/* The remainder has the sign of the divisor; division by 0 returns 0. */
static inline int32_t frob_int_mod(int32_t a, int32_t b)
{
    int32_t rest;
    if (b == 0 || b == -1) {
        return 0;
    }
    rest = a % b;
    return rest != 0 && (rest < 0) != (b < 0) ? rest + b : rest;
}

static inline int32_t frob_int_and(int32_t a, int32_t b)
{
    return frob_wrap((uint32_t)a & (uint32_t)b);
}

static inline int32_t frob_int_or(int32_t a, int32_t b)
{
    return frob_wrap((uint32_t)a | (uint32_t)b);
}

static inline int32_t frob_int_xor(int32_t a, int32_t b)
{
    return frob_wrap((uint32_t)a ^ (uint32_t)b);
}

/* A negative `by` shifts right and preserves the sign. A shift by 32 or more equals that many
 * shifts by 1. */
static inline int32_t frob_int_shift_left(int32_t a, int32_t by)
{
    const uint32_t sign = a < 0 ? 0xffffffffu : 0u;
    if (by < 0) {
        return frob_wrap((((uint32_t)a ^ sign) >> (by < -31 ? 31 : -by)) ^ sign);
    }
    return by > 31 ? 0 : frob_wrap((uint32_t)a << by);
}

static inline int32_t frob_int_shift_right(int32_t a, int32_t by)
{
    return frob_int_shift_left(a, by < -32 ? 32 : -by);
}

/* ---- Local times, in nanoseconds */

/* Adds nanoseconds to a local time; saturates at INT64_MAX. */
static inline int64_t frob_later(int64_t time, int64_t ns)
{
    const uint64_t later = (uint64_t)time + (uint64_t)ns;
    return later < (uint64_t)INT64_MAX ? (int64_t)later : INT64_MAX;
}

/* Adds nanoseconds to a local time that stays far below INT64_MAX. */
static inline int64_t frob_soon(int64_t time, int64_t ns)
{
    const uint64_t soon = (uint64_t)time + (uint64_t)ns;
    return (int64_t)soon;
}

/* Subtracts nanoseconds from the remaining time `*left`, which stops at 0. Returns whether no time
 * is left. `ns` may be any number; a negative number counts as 0. */
static inline bool frob_runs_out(uint32_t *left, int64_t ns)
{
    if (FROB_BRANCH((uint64_t)ns >= *left)) {
        if (ns >= 0) {
            *left = 0;
        }
        return *left == 0;
    }
    *left -= (uint32_t)ns;
    return false;
}

/* Does the same as frob_runs_out if the condition holds; otherwise, resets the remaining time
 * to `all`. */
static inline bool frob_runs_out_while(bool condition, uint32_t *left, int64_t ns, uint32_t all)
{
    if (condition) {
        return frob_runs_out(left, ns);
    }
    *left = all;
    return false;
}

/* Limits a dt in nanoseconds to 0 … 1e18. */
static inline int64_t frob_span(int64_t dt_ns)
{
    const int64_t most = INT64_C(1000000000000000000);
    /* comparing with a 32-bit number first is faster */
    if (FROB_BRANCH((uint64_t)dt_ns > (uint64_t)INT32_MAX)) {
        return dt_ns <= 0 ? 0 : dt_ns < most ? dt_ns : most;
    }
    return dt_ns;
}

/* ---- Doubles */

/* Limits a dt in seconds to 0 … 1e9; returns 0 for NaN. */
static inline double frob_dt(double dt)
{
    const double positive = dt > 0.0 ? dt : 0.0;
    return positive < 1e9 ? positive : 1e9;
}

/* Limits a positive dt in seconds to at most 1e9. */
static inline double frob_short_dt(double dt)
{
    return dt < 1e9 ? dt : 1e9;
}

/* Adds a zero. This is a function because gcc 12 folds fabs(x) in such a sum to the wrong zero. */
static inline double frob_add(double a, double b)
{
    return a + b;
}

/* Subtracts from a zero. This is a function because gcc 12 folds 0.0 - fabs(x) to the wrong
 * zero. */
static inline double frob_subtract(double a, double b)
{
    return a - b;
}

/* Negative zero, hidden from the optimizer: clang 13 to 15 compile `x > 0.0 ? -0.0 : x` as `x >=
 * 0.0 ? -0.0 : x`. Generated code contains no other literal that is a negative zero. */
static inline double frob_negative_zero(void)
{
    const volatile double zero = -0.0;
    return zero;
}

/* Minimum; NaN if either argument is NaN; the first argument if both are equal. */
static inline double frob_min(double a, double b)
{
    if (FROB_BRANCH(b != b)) {
        return b;
    }
    return b < a ? b : a;
}

/* Maximum; NaN if either argument is NaN; the first argument if both are equal. */
static inline double frob_max(double a, double b)
{
    if (FROB_BRANCH(b != b)) {
        return b;
    }
    return b > a ? b : a;
}

/* Minimum of x and a limit that is not NaN; NaN if x is NaN. */
static inline double frob_at_most(double x, double limit)
{
    return limit < x ? limit : x;
}

/* Maximum of x and a limit that is not NaN; NaN if x is NaN. */
static inline double frob_at_least(double x, double limit)
{
    return limit > x ? limit : x;
}

/* Clamps x to low … high, two different numbers that are not zero; NaN if x is NaN. The expressions
 * after #else are equivalent, but gcc would compile them to a branch on x86. */
static inline double frob_clamp(double x, double low, double high)
{
#if defined(__GNUC__) && !defined(__clang__) && defined(__SSE2__)
    const double lower = x < high ? x : high;
    if (FROB_BRANCH(x != x)) {
        return x;
    }
    return lower > low ? lower : low;
#else
    const double lower = high < x ? high : x;
    return low > lower ? low : lower;
#endif
}

/* min 0 x. */
static inline double frob_below_zero(double x)
{
    return x >= 0.0 ? 0.0 : x;
}

/* max 0 x. */
static inline double frob_above_zero(double x)
{
    return x <= 0.0 ? 0.0 : x;
}

/* max (-x) (min x y): clamps y to -x … x; NaN if either is NaN. */
static inline double frob_limit(double x, double y)
{
    if (FROB_BRANCH(y != y)) {
        return y;
    }
    const double high = y < x ? y : x;
    return high > -x ? high : -x;
}

/* Equivalent to frob_limit(frob_above_zero(x), y): clamps y to -x … x, or to 0 if x is negative;
 * NaN if either is NaN. The result for x = -0.0 is -0.0, the same as for x = 0.0. */
static inline double frob_limit_above_zero(double x, double y)
{
    if (FROB_BRANCH(!(x > 0.0))) {
        return x <= 0.0 ? y == y ? -0.0 : y : x;
    }
    const double high = x < y ? x : y;
    return -x > high ? -x : high;
}

/* Sign of x, as 1 or -1; a zero or NaN is returned unchanged. */
static inline double frob_signum(double x)
{
    return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : x;
}

/* Converts to an integer, rounding towards 0; saturates, and converts NaN to 0. */
static inline int32_t frob_truncate(double x)
{
    if (x >= 2147483648.0) {
        return INT32_MAX;
    }
    if (x <= -2147483648.0) {
        return INT32_MIN;
    }
    return x == x ? (int32_t)x : 0;
}

/* The greatest integer not above x; saturates, and converts NaN to 0. */
static inline int32_t frob_floor(double x)
{
    if (FROB_BRANCH(x != x)) {
        return 0;
    }
    const double high = x < 2147483647.0 ? x : 2147483647.0;
    const double inside = high > -2147483648.0 ? high : -2147483648.0;
    const int32_t n = (int32_t)inside;
    return n - ((double)n > inside ? 1 : 0);
}

/* The least integer not below x; saturates, and converts NaN to 0. */
static inline int32_t frob_ceiling(double x)
{
    if (FROB_BRANCH(x != x)) {
        return 0;
    }
    const double low = x > -2147483648.0 ? x : -2147483648.0;
    const double inside = low < 2147483647.0 ? low : 2147483647.0;
    const int32_t n = (int32_t)inside;
    return n + ((double)n < inside ? 1 : 0);
}

/* Rounds to the nearest integer, halves away from 0. */
static inline int32_t frob_round(double x)
{
    const int32_t n = frob_truncate(x);
    const double rest = x - (double)n;
    if (rest >= 0.5 && n < INT32_MAX) {
        return n + 1;
    }
    return rest <= -0.5 && n > INT32_MIN ? n - 1 : n;
}

/* Converts dt to whole nanoseconds, rounding halves to even: adding 2^52 discards the fraction.
 * Returns 0 for NaN and negative numbers, and at most 1e9 s. */
static inline int64_t frob_whole_ns(double dt)
{
    double ns = (1e9 < dt ? 1e9 : dt) * 1e9;
    if (FROB_BRANCH(ns >= 4503599627370496.0)) {
        return (int64_t)ns;
    }
    ns = ns > 0.0 ? ns : 0.0;
    return (int64_t)((ns + 4503599627370496.0) - 4503599627370496.0);
}

/* Rounds dt, in seconds, to whole nanoseconds. dt is almost always the double nearest to such a
 * number already, and checking its bits is faster than dividing. For dt from 2^-10 to 2^22 s, the
 * function multiplies the bits of dt by 4e9 and shifts the product left by the exponent; the 64-bit
 * result is the fraction of a nanosecond. 4e9, shifted by the same amount, is one unit in the last
 * place of dt. */
static inline double frob_whole_dt(double dt)
{
#ifndef __OPTIMIZE_SIZE__
    const uint64_t last_bit = 4000000000u;
    uint64_t bits;
    (void)memcpy(&bits, &dt, sizeof bits);
    const uint32_t exponent = (uint32_t)(bits >> 52) - 1013u;
    if (exponent < 32u && (bits * last_bit + last_bit / 2u) << exponent <= last_bit << exponent) {
        return dt;
    }
#endif
    return (double)frob_whole_ns(dt) / 1e9;
}

/* Converts seconds to whole nanoseconds, rounding halves to even. Returns 0 for negative numbers
 * and NaN for NaN. */
static inline double frob_nanoseconds(double seconds)
{
    const double ns = seconds < 0.0 ? 0.0 : seconds * 1e9;
    return ns < 4503599627370496.0 ? (ns + 4503599627370496.0) - 4503599627370496.0 : ns;
}

/* Converts a local time, which is stored in nanoseconds, to seconds and applies frob_nanoseconds.
 * Skips the conversion for times below 13 days, because converting them to seconds and back changes
 * nothing. */
static inline double frob_time_in_ns(int64_t time)
{
    const double ns = (double)time;
    return FROB_BRANCH(time >= INT64_C(0x4000000000000)) ? frob_nanoseconds(ns / 1e9) : ns;
}

/* Returns whether a time in nanoseconds has reached a period; false if the period is NaN. */
static inline bool frob_reached(int64_t time, double period)
{
    return period < 9223372036854775808.0 && (period < 0.0 || (int64_t)period <= time);
}

/* Returns the remainder of a time divided by a period; the time is at least one period. */
static inline int64_t frob_rest(int64_t time, double period)
{
    return period < 1.0 ? 0 : time % (int64_t)period;
}

/* ---- Floats */

/* Limits a dt in seconds to 0 … 1e9; returns 0 for NaN. */
static inline float frob_dtf(float dt)
{
    const float positive = dt > 0.0f ? dt : 0.0f;
    return positive < 1e9f ? positive : 1e9f;
}

/* Limits a positive dt in seconds to at most 1e9. */
static inline float frob_short_dtf(float dt)
{
    return dt < 1e9f ? dt : 1e9f;
}

/* Adds a zero. This is a function because gcc 12 folds fabs(x) in such a sum to the wrong zero. */
static inline float frob_addf(float a, float b)
{
    return a + b;
}

/* Subtracts from a zero. This is a function because gcc 12 folds 0.0 - fabs(x) to the wrong
 * zero. */
static inline float frob_subtractf(float a, float b)
{
    return a - b;
}

/* Negative zero, hidden from the optimizer: clang 13 to 15 compile `x > 0.0 ? -0.0 : x` as `x >=
 * 0.0 ? -0.0 : x`. Generated code contains no other literal that is a negative zero. */
static inline float frob_negative_zerof(void)
{
    const volatile float zero = -0.0f;
    return zero;
}

/* Minimum; NaN if either argument is NaN; the first argument if both are equal. */
static inline float frob_minf(float a, float b)
{
    if (FROB_BRANCH(b != b)) {
        return b;
    }
    return b < a ? b : a;
}

/* Maximum; NaN if either argument is NaN; the first argument if both are equal. */
static inline float frob_maxf(float a, float b)
{
    if (FROB_BRANCH(b != b)) {
        return b;
    }
    return b > a ? b : a;
}

/* Minimum of x and a limit that is not NaN; NaN if x is NaN. */
static inline float frob_at_mostf(float x, float limit)
{
    return limit < x ? limit : x;
}

/* Maximum of x and a limit that is not NaN; NaN if x is NaN. */
static inline float frob_at_leastf(float x, float limit)
{
    return limit > x ? limit : x;
}

/* Clamps x to low … high, two different numbers that are not zero; NaN if x is NaN. The expressions
 * after #else are equivalent, but gcc would compile them to a branch on x86. */
static inline float frob_clampf(float x, float low, float high)
{
#if defined(__GNUC__) && !defined(__clang__) && defined(__SSE2__)
    const float lower = x < high ? x : high;
    if (FROB_BRANCH(x != x)) {
        return x;
    }
    return lower > low ? lower : low;
#else
    const float lower = high < x ? high : x;
    return low > lower ? low : lower;
#endif
}

/* min 0 x. */
static inline float frob_below_zerof(float x)
{
    return x >= 0.0f ? 0.0f : x;
}

/* max 0 x. */
static inline float frob_above_zerof(float x)
{
    return x <= 0.0f ? 0.0f : x;
}

/* max (-x) (min x y): clamps y to -x … x; NaN if either is NaN. */
static inline float frob_limitf(float x, float y)
{
    if (FROB_BRANCH(y != y)) {
        return y;
    }
    const float high = y < x ? y : x;
    return high > -x ? high : -x;
}

/* Equivalent to frob_limitf(frob_above_zerof(x), y): clamps y to -x … x, or to 0 if x is negative;
 * NaN if either is NaN. The result for x = -0.0 is -0.0, the same as for x = 0.0. */
static inline float frob_limit_above_zerof(float x, float y)
{
    if (FROB_BRANCH(!(x > 0.0f))) {
        return x <= 0.0f ? y == y ? -0.0f : y : x;
    }
    const float high = x < y ? x : y;
    return -x > high ? -x : high;
}

/* Sign of x, as 1 or -1; a zero or NaN is returned unchanged. */
static inline float frob_signumf(float x)
{
    return x > 0.0f ? 1.0f : x < 0.0f ? -1.0f : x;
}

/* Converts to an integer, rounding towards 0; saturates, and converts NaN to 0. */
static inline int32_t frob_truncatef(float x)
{
    if (x >= 2147483648.0f) {
        return INT32_MAX;
    }
    if (x <= -2147483648.0f) {
        return INT32_MIN;
    }
    return x == x ? (int32_t)x : 0;
}

static inline int32_t frob_floorf(float x)
{
    const int32_t n = frob_truncatef(x);
    return (float)n > x && n > INT32_MIN ? n - 1 : n;
}

static inline int32_t frob_ceilingf(float x)
{
    const int32_t n = frob_truncatef(x);
    return (float)n < x && n < INT32_MAX ? n + 1 : n;
}

/* Rounds to the nearest integer, halves away from 0. */
static inline int32_t frob_roundf(float x)
{
    const int32_t n = frob_truncatef(x);
    const float rest = x - (float)n;
    if (rest >= 0.5f && n < INT32_MAX) {
        return n + 1;
    }
    return rest <= -0.5f && n > INT32_MIN ? n - 1 : n;
}

/* Converts dt to whole nanoseconds. Whole seconds and the rest are converted separately, because a
 * float has too few bits for both. Halves round to even: adding 2^23 discards the fraction. Returns
 * 0 for NaN and negative numbers, and at most 1e9 s. */
static inline int64_t frob_whole_nsf(float dt)
{
    if (!(dt > 0.0f)) {
        return 0;
    }
    if (dt >= 1e9f) {
        return INT64_C(1000000000000000000);
    }
    const int32_t s = (int32_t)dt;
    float ns = (dt - (float)s) * 1e9f;
    if (ns < 8388608.0f) {
        ns = (ns + 8388608.0f) - 8388608.0f;
    }
    return (int64_t)s * 1000000000 + (int32_t)ns;
}

/* Converts seconds to whole nanoseconds, rounding halves to even. Returns 0 for negative numbers
 * and NaN for NaN. */
static inline float frob_nanosecondsf(float seconds)
{
    const float ns = seconds < 0.0f ? 0.0f : seconds * 1e9f;
    return ns < 8388608.0f ? (ns + 8388608.0f) - 8388608.0f : ns;
}

/* Converts a local time, which is stored in nanoseconds, to seconds and applies
 * frob_nanosecondsf. */
static inline float frob_time_in_nsf(int64_t time)
{
    return frob_nanosecondsf((float)time / 1e9f);
}

/* Returns whether a time in nanoseconds has reached a period; false if the period is NaN. */
static inline bool frob_reachedf(int64_t time, float period)
{
    return period < 9223372036854775808.0f && (period < 0.0f || (int64_t)period <= time);
}

/* Returns the remainder of a time divided by a period; the time is at least one period. */
static inline int64_t frob_restf(int64_t time, float period)
{
    return period < 1.0f ? 0 : time % (int64_t)period;
}

#endif
