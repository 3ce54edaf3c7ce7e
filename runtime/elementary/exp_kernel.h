/* The exponential function, shared by exp and pow.
 *
 * Table-driven, after P. T. P. Tang, "Table-driven implementation of the
 * exponential function in IEEE floating-point arithmetic", ACM TOMS 15
 * (1989): exp(x) = 2^(k/32) exp(r) with |r| <= log(2)/64. */
#ifndef FROB_ELEMENTARY_EXP_KERNEL_H
#define FROB_ELEMENTARY_EXP_KERNEL_H

#include <math.h>

#include "double_double.h"

/* exp(x.high + x.low); x.high must not be NaN. */
static inline double exp_of_pair(struct pair x)
{
    /* 2^(i/32) */
    static const struct pair roots[32] = {
        { 0x1.p+0, 0.0 },
        { 0x1.059b0d3158574p+0, 0x1.d73e2a475b465p-55 },
        { 0x1.0b5586cf9890fp+0, 0x1.8a62e4adc610bp-54 },
        { 0x1.11301d0125b51p+0, -0x1.6c51039449b3ap-54 },
        { 0x1.172b83c7d517bp+0, -0x1.19041b9d78a76p-55 },
        { 0x1.1d4873168b9aap+0, 0x1.e016e00a2643cp-54 },
        { 0x1.2387a6e756238p+0, 0x1.9b07eb6c70573p-54 },
        { 0x1.29e9df51fdee1p+0, 0x1.612e8afad1255p-55 },
        { 0x1.306fe0a31b715p+0, 0x1.6f46ad23182e4p-55 },
        { 0x1.371a7373aa9cbp+0, -0x1.63aeabf42eae2p-54 },
        { 0x1.3dea64c123422p+0, 0x1.ada0911f09ebcp-55 },
        { 0x1.44e086061892dp+0, 0x1.89b7a04ef80d0p-59 },
        { 0x1.4bfdad5362a27p+0, 0x1.d4397afec42e2p-56 },
        { 0x1.5342b569d4f82p+0, -0x1.07abe1db13cadp-55 },
        { 0x1.5ab07dd485429p+0, 0x1.6324c054647adp-54 },
        { 0x1.6247eb03a5585p+0, -0x1.383c17e40b497p-54 },
        { 0x1.6a09e667f3bcdp+0, -0x1.bdd3413b26456p-54 },
        { 0x1.71f75e8ec5f74p+0, -0x1.16e4786887a99p-55 },
        { 0x1.7a11473eb0187p+0, -0x1.41577ee04992fp-55 },
        { 0x1.82589994cce13p+0, -0x1.d4c1dd41532d8p-54 },
        { 0x1.8ace5422aa0dbp+0, 0x1.6e9f156864b27p-54 },
        { 0x1.93737b0cdc5e5p+0, -0x1.75fc781b57ebcp-57 },
        { 0x1.9c49182a3f090p+0, 0x1.c7c46b071f2bep-56 },
        { 0x1.a5503b23e255dp+0, -0x1.d2f6edb8d41e1p-54 },
        { 0x1.ae89f995ad3adp+0, 0x1.7a1cd345dcc81p-54 },
        { 0x1.b7f76f2fb5e47p+0, -0x1.5584f7e54ac3bp-56 },
        { 0x1.c199bdd85529cp+0, 0x1.11065895048ddp-55 },
        { 0x1.cb720dcef9069p+0, 0x1.503cbd1e949dbp-56 },
        { 0x1.d5818dcfba487p+0, 0x1.2ed02d75b3707p-55 },
        { 0x1.dfc97337b9b5fp+0, -0x1.1a5cd4f184b5cp-54 },
        { 0x1.ea4afa2a490dap+0, -0x1.e9c23179c2893p-54 },
        { 0x1.f50765b6e4540p+0, 0x1.9d3e12dd8a18bp-54 },
    };
    /* log(2)/32 in two parts: the first 36 bits, whose product with k is exact, and the
     * remainder */
    static const double step_high = 0x1.62e42fefap-6;
    static const double step_low = 0x1.cf79abc9e3b3ap-45;

    if (x.high > 709.8)
        return INFINITY;
    if (x.high < -745.2)
        return 0.0;
    int const k = (int)(x.high * 0x1.71547652b82fep5 + (x.high < 0.0 ? -0.5 : 0.5));
    struct pair r = sum(x.high - k * step_high, -(k * step_low));
    r.low += x.low;

    /* Sollya: fpminimax((exp(x)-1-x)/x^2, 4, [|D...|],
             [-log(2)/64; log(2)/64], absolute); error below 2^-61 */
    double const z = r.high + r.low;
    double const p =
        0x1p-1 +
        z * (0x1.555555554dd45p-3 +
             z * (0x1.555555554e947p-5 + z * (0x1.11114f8a7981dp-7 + z * 0x1.6c170ee3ccae7p-10)));
    double const less_one = r.high + (r.low + z * z * p);

    int const i = (int)((unsigned)k & 31u);
    int const exponent = (k - i) / 32;
    double const value = roots[i].high + (roots[i].low + roots[i].high * less_one);
    if (exponent > 1022)
        return value * 2.0 * power_of_two(exponent - 1);
    if (exponent < -1021)
        return value * power_of_two(exponent + 100) * 0x1p-100;
    return value * power_of_two(exponent);
}

#endif
