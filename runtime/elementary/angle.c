#include "angle.h"

#include <math.h>

/* The bits of 2/pi after the binary point, preceded by 64 zeros. */
static const uint32_t two_over_pi[40] = {
    0x00000000u, 0x00000000u, 0xa2f9836eu, 0x4e441529u, 0xfc2757d1u, 0xf534ddc0u, 0xdb629599u,
    0x3c439041u, 0xfe5163abu, 0xdebbc561u, 0xb7246e3au, 0x424dd2e0u, 0x06492eeau, 0x09d1921cu,
    0xfe1deb1cu, 0xb129a73eu, 0xe88235f5u, 0x2ebb4484u, 0xe99c7026u, 0xb45f7e41u, 0x3991d639u,
    0x835339f4u, 0x9c845f8bu, 0xbdf9283bu, 0x1ff897ffu, 0xde05980fu, 0xef2f118bu, 0x5a0a6d1fu,
    0x6d367ecfu, 0x27cb09b7u, 0x4f463f66u, 0x9e5fea2du, 0x7527bac7u, 0xebe5f17bu, 0x3d0739f7u,
    0x8a5292eau, 0x6bfb5fb1u, 0x1f8d5d08u, 0x56033046u, 0xfc7b6babu,
};

#define WORDS 6 /* 32 bits each */

/* Reduces any finite x: multiplies its significand by the bits of 2/pi that matter modulo 4, as a
 * 192-bit integer (M. Payne and R. Hanek, "Radian reduction for trigonometric functions", SIGNUM
 * Newsletter 18, 1983). */
static struct angle reduce_any(double x)
{
    int const whole = exponent_of(x);
    /* |x| = significand 2^exponent. Because |x| is at least 1/2, the lower bound never applies; it
     * only shows that the table index is valid. */
    int const exponent = (whole > -1 ? whole : -1) - 52;
    uint64_t const significand = (bits_of(x) & 0xfffffffffffffu) | 0x10000000000000u;

    /* The 192 bits of 2/pi, starting with the bit of weight 2^(1 - exponent). The bits before it
     * contribute only multiples of 4 to the product. */
    int const first = exponent - 2 + 64;
    int const word = first / 32;
    int const shift = first % 32;
    uint32_t window[WORDS]; /* least significant word first */
    for (int i = 0; i < WORDS; ++i) {
        int const at = word + WORDS - 1 - i;
        uint64_t const two = ((uint64_t)two_over_pi[at] << 32) | two_over_pi[at + 1];
        window[i] = (uint32_t)((two << shift) >> 32);
    }

    /* fraction = significand * window modulo 2^192, which is x / (pi/2) / 4, modulo 1 */
    uint32_t fraction[WORDS] = { 0 };
    uint32_t const half[2] = { (uint32_t)significand, (uint32_t)(significand >> 32) };
    for (int h = 0; h < 2; ++h) {
        uint64_t carry = 0;
        for (int i = h; i < WORDS; ++i) {
            carry += (uint64_t)half[h] * window[i - h] + fraction[i];
            fraction[i] = (uint32_t)carry;
            carry >>= 32;
        }
    }

    /* The two leading bits count quarter turns, and the other bits are a fraction of one. The count
     * is rounded to the nearest integer, so that the remainder is between -1/2 and 1/2; the
     * absolute value of the remainder is computed first. */
    unsigned quarter = fraction[WORDS - 1] >> 30;
    bool const above = (fraction[WORDS - 1] >> 29 & 1u) != 0;
    for (int i = WORDS - 1; i > 0; --i)
        fraction[i] = (fraction[i] << 2) | (fraction[i - 1] >> 30);
    fraction[0] <<= 2;
    if (above) {
        quarter += 1;
        uint64_t carry = 1;
        for (int i = 0; i < WORDS; ++i) {
            carry += (uint32_t)~fraction[i];
            fraction[i] = (uint32_t)carry;
            carry >>= 32;
        }
    }
    struct pair rest = { 0.0, 0.0 };
    double weight = 0x1p-32;
    for (int i = WORDS - 1; i >= 0; --i) {
        struct pair const next = sum(rest.high, fraction[i] * weight);
        rest = sum(next.high, next.low + rest.low);
        weight *= 0x1p-32;
    }

    /* multiply by pi/2 */
    struct pair y = product(rest.high, 0x1.921fb54442d18p0);
    y.low += rest.high * 0x1.1a62633145c07p-54 + rest.low * 0x1.921fb54442d18p0;
    y = sum_ordered(y.high, y.low);

    struct angle a;
    bool const negative = signbit(x) != 0;
    bool const flip = negative != above;
    a.rest.high = flip ? -y.high : y.high;
    a.rest.low = flip ? -y.low : y.low;
    a.quarter = (negative ? 0u - quarter : quarter) & 3u;
    return a;
}

struct angle frob_reduce(double x)
{
    struct angle a;
    double const size = fabs(x);
    if (size < 0x1.921fb54442d18p-1) { /* pi/4 */
        a.rest.high = x;
        a.rest.low = 0.0;
        a.quarter = 0;
        return a;
    }
    if (-0x1p20 < x && x < 0x1p20) {
        /* Subtracts n pi/2, with pi/2 split into three parts. The first two have 33 bits, so their
         * products with n are exact (W. J. Cody and W. Waite, Software Manual for the Elementary
         * Functions, 1980). */
        int const n = (int)(x * 0x1.45f306dc9c883p-1 + (x < 0.0 ? -0.5 : 0.5));
        struct pair const second = sum(x - n * 0x1.921fb544p0, -(n * 0x1.0b4611a6p-34));
        struct pair const third = sum(second.high, -(n * 0x1.3198a2e037073p-69));
        a.rest = sum_ordered(third.high, third.low + second.low);
        a.quarter = (unsigned)n & 3u;
        /* The error of the products is below 2^-100, which is too much if the remainder is tiny. */
        if (fabs(a.rest.high) > 0x1p-32)
            return a;
    }
    return reduce_any(x);
}
