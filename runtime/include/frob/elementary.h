/* Elementary functions that return the same bits on every machine.
 *
 * The C library's sin, exp and similar functions differ in the last bit between machines. These
 * functions use only addition, subtraction, multiplication, division and square root of IEEE 754
 * doubles, which every machine rounds in the same way, so a run recorded on a robot replays bit for
 * bit on a desktop. Compile them, like generated code, with contraction off (-ffp-contract=off) and
 * without -ffast-math.
 *
 * Error bounds are in units in the last place (ulp) of the result, relative to the exact value; a
 * correctly rounded result has an error of at most 0.5 ulp. tests/generated/elementary measures
 * them (`make elementary` measures the single-precision functions for every float). Special cases
 * follow C99, Annex F. No function sets errno. */
#ifndef FROB_ELEMENTARY_H
#define FROB_ELEMENTARY_H

#ifdef __cplusplus
extern "C" {
#endif

/* e to the power x; within 0.53 ulp, or 1 ulp if the result is subnormal. */
double frob_exp(double x);

/* The natural logarithm; within 0.51 ulp. */
double frob_log(double x);

/* x to the power y; within 0.55 ulp, or 1 ulp if the result is subnormal. */
double frob_pow(double x, double y);

/* Sine, cosine and tangent of an angle of any size, in radians; sine and cosine within 0.8 ulp,
 * tangent within 0.9 ulp. */
double frob_sin(double x);
double frob_cos(double x);
double frob_tan(double x);

/* Inverse sine, cosine and tangent, in radians; within 0.55 ulp. */
double frob_asin(double x);
double frob_acos(double x);
double frob_atan(double x);

/* The direction of the point (x, y), in radians from -pi to pi; within 0.55 ulp, or 1 ulp if the
 * result is subnormal. */
double frob_atan2(double y, double x);

/* The distance of the point (x, y) from the origin, without intermediate overflow; within 0.51 ulp,
 * or 1 ulp if the result is subnormal. */
double frob_hypot(double x, double y);

/* The same functions in single precision, computed with integers and floats only, for processors
 * without hardware for doubles. exp and log are within 0.52 ulp, the others within 0.55 ulp. */
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
