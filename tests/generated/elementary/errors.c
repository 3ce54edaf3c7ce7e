/* Measures the errors of the runtime's elementary functions against MPFR, in units in the last
 * place, on random arguments of every kind. Prints one line for each function, and fails if an
 * error exceeds the bound stated in <frob/elementary.h>.
 *
 * usage: errors [COUNT [SEED]]: COUNT arguments for each function and kind */
#include <frob/elementary.h>
#include <math.h>
#include <mpfr.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PRECISION = 300 };

static uint64_t state;

/* splitmix64 */
static uint64_t next(void)
{
    uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static double uniform(double from, double to)
{
    return from + (to - from) * ((double)(next() >> 11) * 0x1p-53);
}

static double any_finite(void)
{
    for (;;) {
        uint64_t const bits = next();
        double x;
        memcpy(&x, &bits, sizeof x);
        if (isfinite(x))
            return x;
    }
}

static double of_scale(double least, double most)
{
    return ldexp(uniform(1.0, 2.0), (int)uniform(least, most));
}

static double either_sign(double x)
{
    return next() & 1u ? x : -x;
}

/* Kinds of arguments: usual values, a wide range, all bit patterns, difficult cases. */
enum { KINDS = 4 };

static double angle(int kind)
{
    switch (kind) {
    case 0: return uniform(-7.0, 7.0);
    case 1: return either_sign(of_scale(-30.0, 30.0));
    case 2: return any_finite();
    default: { /* near a multiple of pi/2 */
        double const n = floor(uniform(-1e6, 1e6));
        return n * 0x1.921fb54442d18p0 * (1.0 + uniform(-4.0, 4.0) * 0x1p-52);
    }
    }
}

static double exponent(int kind)
{
    switch (kind) {
    case 0: return uniform(-1.0, 1.0);
    case 1: return uniform(-746.0, 710.0);
    case 2: return any_finite();
    default: return either_sign(of_scale(-60.0, 9.0));
    }
}

static double positive(int kind)
{
    switch (kind) {
    case 0: return uniform(0.5, 2.0);
    case 1: return uniform(0.99, 1.01);
    case 2: return fabs(any_finite());
    default: return 1.0 + either_sign(of_scale(-53.0, -5.0));
    }
}

static double side(int kind)
{
    switch (kind) {
    case 0: return uniform(-1.0, 1.0);
    case 1: return either_sign(of_scale(-60.0, 0.0));
    case 2: return either_sign(1.0 - of_scale(-54.0, -1.0));
    default: return either_sign(0.5 + uniform(-1e-3, 1e-3));
    }
}

static double slope(int kind)
{
    switch (kind) {
    case 0: return uniform(-5.0, 5.0);
    case 1: return either_sign(of_scale(-70.0, 70.0));
    case 2: return any_finite();
    default: return either_sign(1.0 + uniform(-1e-3, 1e-3));
    }
}

struct points {
    double x;
    double y;
};

static struct points coordinates(int kind)
{
    struct points p;
    switch (kind) {
    case 0:
        p.x = uniform(-10.0, 10.0);
        p.y = uniform(-10.0, 10.0);
        break;
    case 1:
        p.x = either_sign(of_scale(-40.0, 40.0));
        p.y = either_sign(of_scale(-40.0, 40.0));
        break;
    case 2:
        p.x = any_finite();
        p.y = any_finite();
        break;
    default:
        p.x = any_finite();
        p.y = p.x * uniform(-3.0, 3.0);
        if (!isfinite(p.y))
            p.y = p.x;
    }
    return p;
}

static struct points powers(int kind)
{
    struct points p;
    switch (kind) {
    case 0:
        p.x = uniform(0.0, 10.0);
        p.y = uniform(-10.0, 10.0);
        break;
    case 1:
        p.x = fabs(any_finite());
        p.y = uniform(-1.0, 1.0);
        break;
    case 2:
        p.x = 1.0 + either_sign(of_scale(-40.0, -2.0));
        p.y = either_sign(of_scale(0.0, 40.0));
        break;
    default: p.x = -floor(uniform(1.0, 20.0)); p.y = floor(uniform(-60.0, 60.0));
    }
    return p;
}

/* |result - exact| in units of the last place of a double near exact. */
static double error_in_ulp(double result, mpfr_t exact)
{
    double const rounded = mpfr_get_d(exact, MPFR_RNDN);
    if (isnan(rounded))
        return isnan(result) ? 0.0 : INFINITY;
    if (isinf(rounded) || isinf(result))
        return rounded == result ? 0.0 : INFINITY;
    int power;
    (void)frexp(rounded, &power);
    if (power < -1021 || rounded == 0.0)
        power = -1021;
    mpfr_t difference;
    mpfr_init2(difference, PRECISION);
    mpfr_sub_d(difference, exact, result, MPFR_RNDN);
    mpfr_mul_2si(difference, difference, 53 - power, MPFR_RNDN);
    double const error = fabs(mpfr_get_d(difference, MPFR_RNDN));
    mpfr_clear(difference);
    return error;
}

struct function {
    char const *name;
    double (*of_one)(double);
    double (*of_two)(double, double);
    int (*exact_of_one)(mpfr_t, mpfr_srcptr, mpfr_rnd_t);
    int (*exact_of_two)(mpfr_t, mpfr_srcptr, mpfr_srcptr, mpfr_rnd_t);
    double (*argument)(int);
    struct points (*arguments)(int);
    double bound;           /* if the result is a normal number */
    double bound_subnormal; /* if it is subnormal */
};

static const struct function functions[] = {
    { "exp", frob_exp, 0, mpfr_exp, 0, exponent, 0, 0.53, 1.0 },
    { "log", frob_log, 0, mpfr_log, 0, positive, 0, 0.51, 0.51 },
    { "sin", frob_sin, 0, mpfr_sin, 0, angle, 0, 0.8, 0.8 },
    { "cos", frob_cos, 0, mpfr_cos, 0, angle, 0, 0.8, 0.8 },
    { "tan", frob_tan, 0, mpfr_tan, 0, angle, 0, 0.9, 0.9 },
    { "asin", frob_asin, 0, mpfr_asin, 0, side, 0, 0.55, 0.55 },
    { "acos", frob_acos, 0, mpfr_acos, 0, side, 0, 0.55, 0.55 },
    { "atan", frob_atan, 0, mpfr_atan, 0, slope, 0, 0.55, 0.55 },
    { "atan2", 0, frob_atan2, 0, mpfr_atan2, 0, coordinates, 0.55, 1.0 },
    { "hypot", 0, frob_hypot, 0, mpfr_hypot, 0, coordinates, 0.51, 1.0 },
    { "pow", 0, frob_pow, 0, mpfr_pow, 0, powers, 0.55, 1.0 },
};

static bool measure(const struct function *f, long count)
{
    mpfr_t x, y, exact;
    mpfr_inits2(PRECISION, x, y, exact, (mpfr_ptr)0);
    double worst = 0.0;
    double worst_x = 0.0;
    double worst_y = 0.0;
    bool within = true;
    for (int kind = 0; kind < KINDS; ++kind)
        for (long i = 0; i < count; ++i) {
            struct points p = { 0.0, 0.0 };
            double result;
            if (f->of_one) {
                p.x = f->argument(kind);
                mpfr_set_d(x, p.x, MPFR_RNDN);
                f->exact_of_one(exact, x, MPFR_RNDN);
                result = f->of_one(p.x);
            } else {
                p = f->arguments(kind);
                mpfr_set_d(x, p.x, MPFR_RNDN);
                mpfr_set_d(y, p.y, MPFR_RNDN);
                f->exact_of_two(exact, x, y, MPFR_RNDN);
                result = f->of_two(p.x, p.y);
            }
            double const error = error_in_ulp(result, exact);
            bool const normal = fabs(result) >= 0x1p-1022;
            if (error > (normal ? f->bound : f->bound_subnormal))
                within = false;
            if ((normal && error > worst) || error > 1.0) {
                worst = error;
                worst_x = p.x;
                worst_y = p.y;
            }
        }
    mpfr_clears(x, y, exact, (mpfr_ptr)0);
    printf("%s %s within %.2f ulp", within ? "ok" : "FAIL", f->name, f->bound);
    if (getenv("FROB_MEASURE") || !within) {
        printf(", worst %.4f at %a", worst, worst_x);
        if (f->of_two)
            printf(", %a", worst_y);
    }
    printf("\n");
    return within;
}

int main(int argc, char **argv)
{
    long const count = argc > 1 ? strtol(argv[1], 0, 10) : 5000;
    state = argc > 2 ? strtoull(argv[2], 0, 10) : 1;
    bool within = true;
    for (size_t i = 0; i < sizeof functions / sizeof functions[0]; ++i)
        within = measure(&functions[i], count) && within;
    return within ? 0 : 1;
}
