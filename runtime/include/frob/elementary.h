/* Elementary functions with the same bits on every machine.
 *
 * The C library's sin, exp and their like differ in the last bit from machine
 * to machine. These use only addition, subtraction, multiplication, division
 * and square root of IEEE 754 doubles, which every machine rounds alike, so a
 * run that was recorded on a robot replays bit for bit on a desk. Build them,
 * like generated code, with contraction off (-ffp-contract=off) and without
 * -ffast-math.
 *
 * Errors are in units in the last place of the result (ulp) against the exact
 * value; 0.5 would be correctly rounded. tests/generated/elementary measures them (those of
 * single precision for every float: make elementary).
 * Special cases are those of C99, Annex F; no function sets errno. */
#ifndef FROB_ELEMENTARY_H
#define FROB_ELEMENTARY_H

#ifdef __cplusplus
extern "C" {
#endif

/* e to the power x; within 0.53 ulp, 1 ulp where the result is subnormal. */
double frob_exp(double x);

/* The natural logarithm; within 0.51 ulp. */
double frob_log(double x);

/* x to the power y; within 0.55 ulp, 1 ulp where the result is subnormal. */
double frob_pow(double x, double y);

/* Sine, cosine and tangent of an angle in radians, of any size; sine and
 * cosine within 0.8 ulp, the tangent within 0.9 ulp. */
double frob_sin(double x);
double frob_cos(double x);
double frob_tan(double x);

/* Their inverses, in radians; within 0.55 ulp. */
double frob_asin(double x);
double frob_acos(double x);
double frob_atan(double x);

/* The direction of the point (x, y), in radians from -pi to pi; within
 * 0.55 ulp, 1 ulp where the result is subnormal. */
double frob_atan2(double y, double x);

/* The distance of the point (x, y) from the origin, without overflow on the
 * way; within 0.51 ulp, 1 ulp where the result is subnormal. */
double frob_hypot(double x, double y);

/* The same in single precision, for processors that have no doubles: with integers
 * and floats only. exp and log are within 0.52 ulp, the others within 0.55 ulp. */
float frob_expf(float x);
float frob_logf(float x);
float frob_powf(float x, float y);
float frob_sinf(float x);
float frob_cosf(float x);
float frob_tanf(float x);
float frob_asinf(float x);
float frob_acosf(float x);
float frob_atanf(float x);
float frob_atan2f(float y, float x);
float frob_hypotf(float x, float y);

#ifdef __cplusplus
}
#endif

#endif
