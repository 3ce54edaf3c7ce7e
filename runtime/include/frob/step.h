/* What the C that frobc generates calls: integers that wrap around, division that is
 * total, conversions that saturate, minimum and maximum that let a NaN through, time in
 * whole nanoseconds (docs/language.md, "Numbers are total" and "Time").
 *
 * What ends in f is of floats, as in <math.h>, for programs in single precision. All is
 * static inline: what a program does not call costs it nothing. Nothing here has state,
 * traps, or calls more of the C library than <math.h> and memcpy.
 *
 * frobc knows this header too: `frobc compile --standalone` puts what a program needs of
 * it into the file, and a program's own names are none of these. It takes the file apart
 * at blank lines, of which none may be within a definition. */
#ifndef FROB_STEP_H
#define FROB_STEP_H

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include <frob/elementary.h>

/* Generated code defines FROB_SINGLE where all its numbers are floats. */
#if !defined(FROB_SINGLE) && defined(DBL_MANT_DIG) && DBL_MANT_DIG != 53
#error "the program's numbers are IEEE doubles: here it wants `frobc compile --real float`"
#endif

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ != 0) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#error "the program's numbers are IEEE 754's: compile without -ffast-math and its parts"
#endif

#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0
#error "the program's numbers are IEEE 754's: FLT_EVAL_METHOD must be 0"
#endif

/* ---- For compilers */

/* gcc 11 to 13 for aarch64 read a struct too early where two of different types share
 * their place on the stack, unless all accesses may be of the same memory
 * (tests/generated/matrix/shared_stack.c is the whole of it). No attribute of the structs
 * helps, as these are variables and no pointers. Only for that machine: a function with
 * the pragma is not taken into a caller without it, which link-time optimization does
 * otherwise. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__aarch64__)
#pragma GCC optimize("no-strict-aliasing")
#endif

/* The condition of a branch that is to stay one, for the processor to predict:
 * a select in its place would have each step wait for the one before. */
#ifdef __GNUC__
#define FROB_BRANCH(condition) (__builtin_expect((condition), 0) != 0)
#else
#define FROB_BRANCH(condition) (condition)
#endif

/* ---- Truth values */

/* a && b, a || b, where a C compiler would warn that it knows what they come to. */
static inline bool frob_both(bool a, bool b)
{
    return a && b;
}

static inline bool frob_either(bool a, bool b)
{
    return a || b;
}

/* ---- Integers */

/* The number that a 32-bit register holds, read as signed. */
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

/* The least integer is its own absolute value. */
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

/* Rounds to minus infinity; by 0 gives 0. */
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

/* Has the sign of the divisor; by 0 gives 0. */
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

/* By a negative number to the right, where the sign stays; by 32 or more, what as
 * many by 1 come to. */
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

/* A local time after some more nanoseconds; stops at the end of time. */
static inline int64_t frob_later(int64_t time, int64_t ns)
{
    const uint64_t later = (uint64_t)time + (uint64_t)ns;
    return later < (uint64_t)INT64_MAX ? (int64_t)later : INT64_MAX;
}

/* A local time after some more nanoseconds, where it stays far from the end of time. */
static inline int64_t frob_soon(int64_t time, int64_t ns)
{
    const uint64_t soon = (uint64_t)time + (uint64_t)ns;
    return (int64_t)soon;
}

/* A dt in nanoseconds: not negative, at most 1e18. */
static inline int64_t frob_span(int64_t dt_ns)
{
    const int64_t most = INT64_C(1000000000000000000);
    return dt_ns > 0 ? (dt_ns < most ? dt_ns : most) : 0;
}

/* ---- Doubles */

/* Of a zero; a function, for gcc 12 folds fabs(x) in such a sum to the wrong zero. */
static inline double frob_add(double a, double b)
{
    return a + b;
}

/* From a zero; a function, for gcc 12 folds 0.0 - fabs(x) to the wrong zero. */
static inline double frob_subtract(double a, double b)
{
    return a - b;
}

/* NaN if either is; the first of two equal ones. */
static inline double frob_min(double a, double b)
{
    if (FROB_BRANCH(b != b)) {
        return b;
    }
    return b < a ? b : a;
}

/* NaN if either is; the first of two equal ones. */
static inline double frob_max(double a, double b)
{
    if (FROB_BRANCH(b != b)) {
        return b;
    }
    return b > a ? b : a;
}

/* The minimum with a limit that is not NaN; NaN if x is. */
static inline double frob_at_most(double x, double limit)
{
    return limit < x ? limit : x;
}

/* The maximum with a limit that is not NaN; NaN if x is. */
static inline double frob_at_least(double x, double limit)
{
    return limit > x ? limit : x;
}

/* max (-x) (min x y): y within x of 0; NaN if either is. */
static inline double frob_limit(double x, double y)
{
    if (FROB_BRANCH(y != y)) {
        return y;
    }
    const double high = y < x ? y : x;
    return high > -x ? high : -x;
}

/* Of a zero or NaN, itself. */
static inline double frob_signum(double x)
{
    return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : x;
}

/* To an integer, toward 0; saturates, and NaN gives 0. */
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

/* The greatest integer that is not above; saturates, and NaN gives 0. */
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

/* The least integer that is not below; saturates, and NaN gives 0. */
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

/* To the nearest integer, halves away from 0. */
static inline int32_t frob_round(double x)
{
    const int32_t n = frob_truncate(x);
    const double rest = x - (double)n;
    if (rest >= 0.5 && n < INT32_MAX) {
        return n + 1;
    }
    return rest <= -0.5 && n > INT32_MIN ? n - 1 : n;
}

/* dt in nanoseconds, a whole number of them, halves to even: adding 2^52
 * leaves no bits for a fraction. NaN and negative give 0; at most 1e9 s. */
static inline int64_t frob_whole_ns(double dt)
{
    double ns = (1e9 < dt ? 1e9 : dt) * 1e9;
    if (FROB_BRANCH(ns >= 4503599627370496.0)) {
        return (int64_t)ns;
    }
    ns = ns > 0.0 ? ns : 0.0;
    return (int64_t)((ns + 4503599627370496.0) - 4503599627370496.0);
}

/* dt rounded to whole nanoseconds, in seconds. Almost always dt is the double nearest
 * to such a number already, and its bits tell that sooner than a division: from 2^-10
 * to 2^22 s they, times 4e9 and shifted left by the exponent, are the fraction of a
 * nanosecond in 64 bits, and 4e9, shifted alike, is as much as a step of dt's last bit. */
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

/* Whole nanoseconds in seconds, halves to even; of negative ones 0, of NaN NaN. */
static inline double frob_nanoseconds(double seconds)
{
    const double ns = seconds < 0.0 ? 0.0 : seconds * 1e9;
    return ns < 4503599627370496.0 ? (ns + 4503599627370496.0) - 4503599627370496.0 : ns;
}

/* Of the seconds of a local time, which is kept in nanoseconds; for the first
 * 13 days the roundings leave no trace. */
static inline double frob_time_in_ns(int64_t time)
{
    const double ns = (double)time;
    return FROB_BRANCH(time >= INT64_C(0x4000000000000)) ? frob_nanoseconds(ns / 1e9) : ns;
}

/* Has a time in nanoseconds come to so many? Not if that is NaN. */
static inline bool frob_reached(int64_t time, double period)
{
    return period < 9223372036854775808.0 && (period < 0.0 || (int64_t)period <= time);
}

/* Of a time that has come to a period, what is left after whole ones. */
static inline int64_t frob_rest(int64_t time, double period)
{
    return period < 1.0 ? 0 : time % (int64_t)period;
}

/* ---- Floats */

/* Of a zero; a function, for gcc 12 folds fabs(x) in such a sum to the wrong zero. */
static inline float frob_addf(float a, float b)
{
    return a + b;
}

/* From a zero; a function, for gcc 12 folds 0.0 - fabs(x) to the wrong zero. */
static inline float frob_subtractf(float a, float b)
{
    return a - b;
}

/* NaN if either is; the first of two equal ones. */
static inline float frob_minf(float a, float b)
{
    if (FROB_BRANCH(b != b)) {
        return b;
    }
    return b < a ? b : a;
}

/* NaN if either is; the first of two equal ones. */
static inline float frob_maxf(float a, float b)
{
    if (FROB_BRANCH(b != b)) {
        return b;
    }
    return b > a ? b : a;
}

/* The minimum with a limit that is not NaN; NaN if x is. */
static inline float frob_at_mostf(float x, float limit)
{
    return limit < x ? limit : x;
}

/* The maximum with a limit that is not NaN; NaN if x is. */
static inline float frob_at_leastf(float x, float limit)
{
    return limit > x ? limit : x;
}

/* max (-x) (min x y): y within x of 0; NaN if either is. */
static inline float frob_limitf(float x, float y)
{
    if (FROB_BRANCH(y != y)) {
        return y;
    }
    const float high = y < x ? y : x;
    return high > -x ? high : -x;
}

/* Of a zero or NaN, itself. */
static inline float frob_signumf(float x)
{
    return x > 0.0f ? 1.0f : x < 0.0f ? -1.0f : x;
}

/* To an integer, toward 0; saturates, and NaN gives 0. */
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

/* To the nearest integer, halves away from 0. */
static inline int32_t frob_roundf(float x)
{
    const int32_t n = frob_truncatef(x);
    const float rest = x - (float)n;
    if (rest >= 0.5f && n < INT32_MAX) {
        return n + 1;
    }
    return rest <= -0.5f && n > INT32_MIN ? n - 1 : n;
}

/* dt in nanoseconds: of whole seconds and of their fraction, for a float has too
 * few bits for both. Halves to even: adding 2^23 leaves no bits for a fraction.
 * NaN and negative give 0; at most 1e9 s. */
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

/* Whole nanoseconds in seconds, halves to even; of negative ones 0, of NaN NaN. */
static inline float frob_nanosecondsf(float seconds)
{
    const float ns = seconds < 0.0f ? 0.0f : seconds * 1e9f;
    return ns < 8388608.0f ? (ns + 8388608.0f) - 8388608.0f : ns;
}

/* Of the seconds of a local time, which is kept in nanoseconds. */
static inline float frob_time_in_nsf(int64_t time)
{
    return frob_nanosecondsf((float)time / 1e9f);
}

/* Has a time in nanoseconds come to so many? Not if that is NaN. */
static inline bool frob_reachedf(int64_t time, float period)
{
    return period < 9223372036854775808.0f && (period < 0.0f || (int64_t)period <= time);
}

/* Of a time that has come to a period, what is left after whole ones. */
static inline int64_t frob_restf(int64_t time, float period)
{
    return period < 1.0f ? 0 : time % (int64_t)period;
}

#endif
