/* <math.h>, for frob-tcc: the part of the standard header that Frob needs. */
#ifndef FROB_TCC_MATH_H
#define FROB_TCC_MATH_H

/* Functions whose results IEEE 754 specifies exactly. */
double floor(double x);
float floorf(float x);
double ceil(double x);
float ceilf(float x);
double trunc(double x);
float truncf(float x);
double sqrt(double x);
float sqrtf(float x);
double fabs(double x);
float fabsf(float x);
double copysign(double x, double y);
float copysignf(float x, float y);
double fma(double x, double y, double z);
float fmaf(float x, float y, float z);
double fmax(double x, double y);
float fmaxf(float x, float y);
double fmin(double x, double y);
float fminf(float x, float y);
double fmod(double x, double y);
float fmodf(float x, float y);
double ldexp(double x, int n);
float ldexpf(float x, int n);
double frexp(double x, int *n);
float frexpf(float x, int *n);
double nextafter(double x, double y);
float nextafterf(float x, float y);
double rint(double x);
double round(double x);
long lround(double x);
long lrint(double x);

int __isnan(double x);
int __isinf(double x);
int __finite(double x);
int __signbit(double x);

/* These also accept floats: the conversion to double preserves the sign, NaN and infinity. */
#define isnan(x) (__isnan(x) != 0)
#define isinf(x) (__isinf(x) != 0)
#define isfinite(x) (__finite(x) != 0)
#define signbit(x) (__signbit(x) != 0)

#define INFINITY 1e10000f
#define NAN (0.0f / 0.0f)
#define HUGE_VAL 1e10000

#endif
