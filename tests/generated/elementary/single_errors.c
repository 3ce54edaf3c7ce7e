/* Measures the errors of the single-precision elementary functions, in units in the last place,
 * against those of double precision, whose own errors (see errors.c) are less than a billionth
 * of such a unit. Prints one line for each function, and fails if an error exceeds the bound
 * stated in <frob/elementary.h>.
 *
 * usage: single_errors [STEP [NAME]]: tests one float in STEP for functions of one argument; 1
 * tests all 2^32. For functions of two arguments it tests the same number of pairs. NAME
 * restricts the test to one function. */
#include <frob/elementary.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint64_t state = 1;

/* splitmix64 */
static uint32_t next(void)
{
    uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (uint32_t)(z >> 32);
}

static float of_bits(uint32_t bits)
{
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* A random number of either sign, from 2^-range to 2^range. */
static float of_scale(uint32_t range)
{
    uint32_t const exponent = 127 - range + next() % (2 * range + 1);
    return of_bits((next() & 0x807fffffu) | exponent << 23);
}

static float near_one(void)
{
    return 1.0f + of_scale(12) * 0x1p-13f;
}

struct points {
    float x;
    float y;
};

enum { KINDS = 4 };

static struct points coordinates(unsigned kind)
{
    struct points p;
    switch (kind) {
    case 0: p.x = of_bits(next()), p.y = of_bits(next()); break;
    case 1: p.x = of_scale(4), p.y = of_scale(4); break;
    case 2: p.x = of_scale(40), p.y = p.x * near_one(); break;
    default: p.x = of_bits(next()), p.y = p.x * of_scale(20);
    }
    return p;
}

static struct points powers(unsigned kind)
{
    struct points p;
    switch (kind) {
    case 0: p.x = of_bits(next()), p.y = of_bits(next()); break;
    case 1: p.x = fabsf(of_scale(3)), p.y = of_scale(5); break;
    case 2: p.x = near_one(), p.y = of_scale(30); break;
    default: p.x = -floorf(fabsf(of_scale(5))), p.y = floorf(of_scale(6));
    }
    return p;
}

/* |result - exact| in units of the last place of a float near exact. */
static double error_in_ulp(float result, double exact)
{
    float const rounded = (float)exact;
    int power;
    if (isnan(exact))
        return isnan(result) ? 0.0 : INFINITY;
    if ((signbit(result) != 0) != (signbit(exact) != 0))
        return INFINITY;
    if (isinf(rounded) || isinf(result))
        return rounded == result ? 0.0 : INFINITY;
    (void)frexp(exact, &power);
    if (power < -125 || exact == 0.0)
        power = -125;
    return fabs((double)result - exact) * ldexp(1.0, 24 - power);
}

struct worst {
    double error;
    float x;
    float y;
};

static void look(struct worst *w, float result, double exact, float x, float y)
{
    double const error = error_in_ulp(result, exact);
    if (error > w->error) {
        w->error = error;
        w->x = x;
        w->y = y;
    }
}

static bool said(char const *name, double bound, struct worst w)
{
    bool const within = w.error <= bound;
    printf("%s %sf within %.2f ulp", within ? "ok" : "FAIL", name, bound);
    if (getenv("FROB_MEASURE") || !within)
        printf(", worst %.4f at %a, %a", w.error, (double)w.x, (double)w.y);
    printf("\n");
    return within;
}

static const struct {
    char const *name;
    float (*f)(float);
    double (*exact)(double);
    double bound;
} of_one[] = {
    { "exp", frob_expf, frob_exp, 0.52 },    { "log", frob_logf, frob_log, 0.52 },
    { "sin", frob_sinf, frob_sin, 0.55 },    { "cos", frob_cosf, frob_cos, 0.55 },
    { "tan", frob_tanf, frob_tan, 0.55 },    { "asin", frob_asinf, frob_asin, 0.55 },
    { "acos", frob_acosf, frob_acos, 0.55 }, { "atan", frob_atanf, frob_atan, 0.55 },
};

static const struct {
    char const *name;
    float (*f)(float, float);
    double (*exact)(double, double);
    struct points (*arguments)(unsigned);
    double bound;
} of_two[] = {
    { "pow", frob_powf, frob_pow, powers, 0.55 },
    { "atan2", frob_atan2f, frob_atan2, coordinates, 0.55 },
    { "hypot", frob_hypotf, frob_hypot, coordinates, 0.55 },
};

static const float special[] = {
    0.0f,           1.0f,        2.0f,     3.0f, 0.5f, 0.75f, 0x1p-149f, 0x1p-126f, 0x1.fffffep127f,
    0x1.fffffep-1f, 16777216.0f, INFINITY, NAN
};

enum { SPECIALS = 2 * (int)(sizeof special / sizeof special[0]) };

static float special_of(int k)
{
    return k % 2 ? -special[k / 2] : special[k / 2];
}

int main(int argc, char **argv)
{
    uint64_t const step = argc > 1 ? strtoull(argv[1], 0, 10) : 10007;
    char const *only = argc > 2 ? argv[2] : 0;
    uint64_t const count = 0x100000000u / step;
    bool within = true;
    for (size_t i = 0; i < sizeof of_one / sizeof of_one[0]; ++i) {
        struct worst w = { 0.0, 0.0f, 0.0f };
        if (only && strcmp(only, of_one[i].name) != 0)
            continue;
        for (int k = 0; k < SPECIALS; ++k) {
            float const x = special_of(k);
            look(&w, of_one[i].f(x), of_one[i].exact((double)x), x, 0.0f);
        }
        for (uint64_t k = 0; k < count; ++k) {
            float const x = of_bits((uint32_t)(k * step));
            look(&w, of_one[i].f(x), of_one[i].exact((double)x), x, 0.0f);
        }
        within = said(of_one[i].name, of_one[i].bound, w) && within;
        fflush(stdout);
    }
    for (size_t i = 0; i < sizeof of_two / sizeof of_two[0]; ++i) {
        struct worst w = { 0.0, 0.0f, 0.0f };
        if (only && strcmp(only, of_two[i].name) != 0)
            continue;
        for (int k = 0; k < SPECIALS * SPECIALS; ++k) {
            float const x = special_of(k / SPECIALS);
            float const y = special_of(k % SPECIALS);
            look(&w, of_two[i].f(x, y), of_two[i].exact((double)x, (double)y), x, y);
        }
        for (uint64_t k = 0; k < count; ++k) {
            struct points const p = of_two[i].arguments((unsigned)(k % KINDS));
            look(&w, of_two[i].f(p.x, p.y), of_two[i].exact((double)p.x, (double)p.y), p.x, p.y);
        }
        within = said(of_two[i].name, of_two[i].bound, w) && within;
        fflush(stdout);
    }
    return within ? 0 : 1;
}
