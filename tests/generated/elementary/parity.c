/* Tests properties that the compiler relies on, for all bits of the result, all arguments, and
 * both precisions: cos and hypot do not depend on the signs of their arguments, and hypot
 * does not depend on their order. Prints one line, `ok` or `FAIL`.
 *
 * usage: parity [COUNT]: the number of random bit patterns to test in addition to special
 * numbers. */
#include <frob/elementary.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
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

/* Frob does not distinguish NaNs. */
static bool same(double a, double b)
{
    return isnan(a) ? isnan(b) : memcmp(&a, &b, sizeof a) == 0;
}

static bool same_float(float a, float b)
{
    return isnan(a) ? isnan(b) : memcmp(&a, &b, sizeof a) == 0;
}

static bool holds(double x, double y)
{
    double const h = frob_hypot(x, y);
    float const a = (float)x;
    float const b = (float)y;
    float const hf = frob_hypotf(a, b);
    bool const ok = same(frob_cos(-x), frob_cos(x)) && same(frob_hypot(y, x), h) &&
                    same(frob_hypot(-x, y), h) && same(frob_hypot(x, -y), h) &&
                    same_float(frob_cosf(-a), frob_cosf(a)) && same_float(frob_hypotf(b, a), hf) &&
                    same_float(frob_hypotf(-a, b), hf) && same_float(frob_hypotf(a, -b), hf);
    if (!ok)
        printf("FAIL %a, %a\n", x, y);
    return ok;
}

/* Tests one random case. By kind: any bits; numbers of similar size; and equal or nearly equal
 * numbers. */
static bool random_holds(unsigned kind)
{
    uint64_t const bits = next();
    double x;
    memcpy(&x, &bits, sizeof x);
    if (kind == 0) {
        uint64_t const others = next();
        double y;
        memcpy(&y, &others, sizeof y);
        return holds(x, y);
    }
    if (kind == 1)
        return holds((double)(int64_t)bits * 0x1p-60, (double)(int64_t)next() * 0x1p-58);
    return holds(x, x * (1.0 + (double)(next() >> 62) * 0x1p-52));
}

int main(int argc, char **argv)
{
    static double const special[] = { 0.0,       1.0,      3.0,      0x1p-1074,
                                      0x1p-1022, 0x1p-540, 0x1p-149, 0x1p-70,
                                      0x1p+127,  0x1p+511, 0x1p+600, 0x1.fffffffffffffp+1023,
                                      0x1p+1000, 0.75,     INFINITY, NAN,
                                      1e-8,      1e8 };
    size_t const count = sizeof special / sizeof *special;
    long const random = argc > 1 ? atol(argv[1]) : 1000000;
    bool ok = true;
    for (size_t i = 0; i < count; i++) {
        for (size_t j = 0; j < count; j++)
            ok = holds(special[i], special[j]) && ok;
    }
    for (long i = 0; i < random; i++)
        ok = random_holds((unsigned)(i % 3)) && ok;
    puts(ok ? "ok cos and hypot do not look at signs" : "FAIL");
    return ok ? 0 : 1;
}
