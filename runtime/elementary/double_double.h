/* Double-double arithmetic: a number is an unevaluated sum high + low, with |low| at most half a
 * unit in the last place of high.
 *
 * T. J. Dekker, "A floating-point technique for extending the available precision", Numerische
 * Mathematik 18 (1971); D. E. Knuth, The Art of Computer Programming, vol. 2, 4.2.2. */
#ifndef FROB_ELEMENTARY_DOUBLE_DOUBLE_H
#define FROB_ELEMENTARY_DOUBLE_DOUBLE_H

#include <stdint.h>
#include <string.h>

struct pair {
    double high;
    double low;
};

/* a + b exactly; requires |a| >= |b| or a = 0. */
static inline struct pair sum_ordered(double a, double b)
{
    struct pair s;
    s.high = a + b;
    s.low = b - (s.high - a);
    return s;
}

/* a + b exactly. */
static inline struct pair sum(double a, double b)
{
    struct pair s;
    s.high = a + b;
    double const of_b = s.high - a;
    s.low = (a - (s.high - of_b)) + (b - of_b);
    return s;
}

/* Splits a into two parts of at most 26 bits each; requires |a| < 2^996. */
static inline struct pair halves(double a)
{
    double const scaled = 134217729.0 * a; /* 2^27 + 1 */
    struct pair s;
    s.high = scaled - (scaled - a);
    s.low = a - s.high;
    return s;
}

/* a * b exactly, unless the product overflows or some part of it underflows. */
static inline struct pair product(double a, double b)
{
    struct pair const x = halves(a);
    struct pair const y = halves(b);
    struct pair p;
    p.high = a * b;
    p.low = ((x.high * y.high - p.high) + x.high * y.low + x.low * y.high) + x.low * y.low;
    return p;
}

/* The quotient of two positive pairs, to about 100 bits. */
static inline struct pair quotient(struct pair a, struct pair b)
{
    double const q = a.high / b.high;
    struct pair const back = product(q, b.high);
    double const rest = (((a.high - back.high) - back.low) + a.low) - q * b.low;
    return sum_ordered(q, rest / b.high);
}

static inline uint64_t bits_of(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static inline double of_bits(uint64_t bits)
{
    double x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* 2^k for -1022 <= k <= 1023, so that the result is a normal number. */
static inline double power_of_two(int k)
{
    return of_bits((uint64_t)(k + 1023) << 52);
}

/* The exponent without its bias: floor(log2 |x|) for a normal x. */
static inline int exponent_of(double x)
{
    return (int)((bits_of(x) >> 52) & 0x7ff) - 1023;
}

#endif
