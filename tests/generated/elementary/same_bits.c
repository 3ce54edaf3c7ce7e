/* Prints a hash of the results of each elementary function for 20,000 random arguments. The test
 * compares it with same_bits.expected: every compiler and machine must produce the same,
 * otherwise one of them rounds differently. */
#include <frob/elementary.h>
#include <inttypes.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

static uint64_t state = 1;

/* splitmix64 */
static uint64_t next(void)
{
    uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/* A random number of either sign, whose exponent is between -range and range. */
static double argument(uint64_t range)
{
    uint64_t const bits = next();
    uint64_t const exponent = 1023 - range + (bits >> 52) % (2 * range + 1);
    uint64_t const all = (bits & 0x8000000000000000u) | exponent << 52 | (next() >> 12);
    double x;
    memcpy(&x, &all, sizeof x);
    return x;
}

static uint64_t mix(uint64_t hash, double x)
{
    uint64_t bits = 0x7ff8000000000000u; /* all NaNs become this one */
    if (!isnan(x))
        memcpy(&bits, &x, sizeof bits);
    for (int i = 0; i < 64; i += 8)
        hash = (hash ^ ((bits >> i) & 0xff)) * 0x100000001b3u; /* FNV-1a */
    return hash;
}

/* The single-precision functions, with results as doubles. */
#define SINGLE(name)                             \
    static double single_##name(double x)        \
    {                                            \
        return (double)frob_##name##f((float)x); \
    }
#define SINGLE_OF_TWO(name)                                \
    static double single_##name(double x, double y)        \
    {                                                      \
        return (double)frob_##name##f((float)x, (float)y); \
    }
SINGLE(exp)
SINGLE(log)
SINGLE(sin)
SINGLE(cos)
SINGLE(tan)
SINGLE(asin)
SINGLE(acos)
SINGLE(atan)
SINGLE_OF_TWO(atan2)
SINGLE_OF_TWO(hypot)
SINGLE_OF_TWO(pow)

enum { COUNT = 20000 };

static void one(char const *name, double (*f)(double), uint64_t range)
{
    uint64_t hash = 0xcbf29ce484222325u;
    for (int i = 0; i < COUNT; ++i)
        hash = mix(hash, f(argument(range)));
    printf("%s %016" PRIx64 "\n", name, hash);
}

static void two(char const *name, double (*f)(double, double), uint64_t range)
{
    uint64_t hash = 0xcbf29ce484222325u;
    for (int i = 0; i < COUNT; ++i) {
        double const x = argument(range);
        hash = mix(hash, f(x, argument(range)));
    }
    printf("%s %016" PRIx64 "\n", name, hash);
}

int main(void)
{
    one("exp", frob_exp, 10);
    one("log", frob_log, 1022);
    one("sin", frob_sin, 1022);
    one("cos", frob_cos, 40);
    one("tan", frob_tan, 40);
    one("asin", frob_asin, 1);
    one("acos", frob_acos, 1);
    one("atan", frob_atan, 60);
    two("atan2", frob_atan2, 40);
    two("hypot", frob_hypot, 40);
    two("pow", frob_pow, 6);
    one("expf", single_exp, 8);
    one("logf", single_log, 120);
    one("sinf", single_sin, 120);
    one("cosf", single_cos, 40);
    one("tanf", single_tan, 40);
    one("asinf", single_asin, 1);
    one("acosf", single_acos, 1);
    one("atanf", single_atan, 60);
    two("atan2f", single_atan2, 40);
    two("hypotf", single_hypot, 40);
    two("powf", single_pow, 4);
    return 0;
}
