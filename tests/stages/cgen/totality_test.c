/* Tests that operations on numbers are total: the corner cases that C leaves undefined, as
 * section 4 of the language reference defines them. */
#include "totality.h"
#include <math.h>
#include <stdio.h>

static int failures;

static void check(const char *name, bool ok)
{
    printf("%s %s\n", ok ? "ok" : "FAIL", name);
    failures += ok ? 0 : 1;
}

static struct totality_output run(int32_t a, int32_t b, double x, double y)
{
    struct totality_state state;
    struct totality_input in;
    struct totality_output out;
    in.a = a;
    in.b = b;
    in.x = x;
    in.y = y;
    totality_reset(&state);
    totality_step(&state, 0.0, &in, &out);
    return out;
}

static struct totality_output ints(int32_t a, int32_t b)
{
    return run(a, b, 0.0, 0.0);
}

static struct totality_output floats(double x, double y)
{
    return run(0, 0, x, y);
}

static void divide(int32_t a, int32_t b, int32_t quotient, int32_t rest)
{
    char name[80];
    snprintf(name, sizeof name, "%ld div and mod %ld", (long)a, (long)b);
    check(name, ints(a, b).div == quotient && ints(a, b).mod == rest);
}

static void convert(double x, int32_t rounded, int32_t floored, int32_t ceiling, int32_t truncated)
{
    const struct totality_output out = floats(x, 0.0);
    char name[80];
    snprintf(name, sizeof name, "%.17g as an integer", x);
    check(name, out.round == rounded && out.floor == floored && out.ceiling == ceiling &&
                    out.truncate == truncated);
}

static bool minus_zero(double x)
{
    return x == 0.0 && signbit(x) != 0;
}

static bool plus_zero(double x)
{
    return x == 0.0 && signbit(x) == 0;
}

int main(void)
{
    const double nan = (double)NAN, inf = (double)INFINITY;

    check("sums wrap around", ints(INT32_MAX, 1).add == INT32_MIN);
    check("differences wrap around", ints(INT32_MIN, 1).sub == INT32_MAX);
    check("products wrap around", ints(INT32_MIN, -1).mul == INT32_MIN);
    check("large products wrap around", ints(65537, 65537).mul == 131073);
    check("the least integer is its own negation", ints(INT32_MIN, 0).negate == INT32_MIN);
    check("the least integer is its own absolute value", ints(INT32_MIN, 0).abs == INT32_MIN);
    check("signum", ints(-5, 0).signum == -1 && ints(0, 0).signum == 0 && ints(9, 0).signum == 1);
    check("min and max", ints(-5, 3).min == -5 && ints(-5, 3).max == 3);

    divide(7, 2, 3, 1);
    divide(-7, 2, -4, 1);
    divide(7, -2, -4, -1);
    divide(-7, -2, 3, -1);
    divide(-6, 2, -3, 0);
    divide(5, 0, 0, 0);
    divide(INT32_MIN, 0, 0, 0);
    divide(INT32_MIN, -1, INT32_MIN, 0);
    divide(INT32_MIN, 1, INT32_MIN, 0);
    divide(INT32_MIN, INT32_MAX, -2, 2147483646);
    divide(INT32_MAX, INT32_MIN, -1, -1);

    convert(0.5, 1, 0, 1, 0);
    convert(-0.5, -1, -1, 0, 0);
    convert(1.5, 2, 1, 2, 1);
    convert(2.5, 3, 2, 3, 2);
    convert(-2.5, -3, -3, -2, -2);
    convert(0.49999999999999994, 0, 0, 1, 0);
    convert(2147483646.5, 2147483647, 2147483646, 2147483647, 2147483646);
    convert(2147483647.5, 2147483647, 2147483647, 2147483647, 2147483647);
    convert(-2147483647.5, INT32_MIN, INT32_MIN, -2147483647, -2147483647);
    convert(-2147483648.5, INT32_MIN, INT32_MIN, INT32_MIN, INT32_MIN);
    convert(1e300, INT32_MAX, INT32_MAX, INT32_MAX, INT32_MAX);
    convert(-1e300, INT32_MIN, INT32_MIN, INT32_MIN, INT32_MIN);
    convert(inf, INT32_MAX, INT32_MAX, INT32_MAX, INT32_MAX);
    convert(-inf, INT32_MIN, INT32_MIN, INT32_MIN, INT32_MIN);
    convert(nan, 0, 0, 0, 0);
    convert(-0.0, 0, 0, 0, 0);

    check("min is NaN if the first is", isnan(floats(nan, 1.0).fmin) != 0);
    check("min is NaN if the second is", isnan(floats(1.0, nan).fmin) != 0);
    check("max is NaN if the first is", isnan(floats(nan, 1.0).fmax) != 0);
    check("max is NaN if the second is", isnan(floats(1.0, nan).fmax) != 0);
    check("min is the first of equals", minus_zero(floats(-0.0, 0.0).fmin));
    check("min is the first of equals, plus", plus_zero(floats(0.0, -0.0).fmin));
    check("max is the first of equals", minus_zero(floats(-0.0, 0.0).fmax));
    check("max is the first of equals, plus", plus_zero(floats(0.0, -0.0).fmax));
    check("min and max of different ones",
          floats(2.0, 1.0).fmin == 1.0 && floats(1.0, 2.0).fmax == 2.0);
    check("min with infinity", floats(inf, 1.0).fmin == 1.0 && floats(-inf, 1.0).fmax == 1.0);
    check("a literal limit lets NaN through", isnan(floats(nan, 0.0).capped) != 0);
    check("a literal limit on the left too", isnan(floats(nan, 0.0).raised) != 0);
    check("literal limits limit",
          floats(3.0, 0.0).capped == 1.0 && floats(-3.0, 0.0).raised == 1.0);
    check("min x 0 is the first of equals", minus_zero(floats(-0.0, 0.0).min0));
    check("max 0 x is the first of equals", plus_zero(floats(-0.0, 0.0).max0));
    check("max 0 of NaN is NaN", isnan(floats(nan, 0.0).max0) != 0);
    check("a limit limits", floats(2.0, 3.0).limit == 2.0 && floats(2.0, -3.0).limit == -2.0);
    check("a limit keeps what is inside", floats(2.0, 1.0).limit == 1.0);
    check("a limit is NaN if either is",
          isnan(floats(nan, 1.0).limit) != 0 && isnan(floats(1.0, nan).limit) != 0);
    check("a negative limit is the maximum",
          floats(-2.0, 5.0).limit == 2.0 && floats(-2.0, -5.0).limit == 2.0);
    check("a limit of 0 gives the first of equals", minus_zero(floats(0.0, 1.0).limit));
    check("signum of minus zero is itself", minus_zero(floats(-0.0, 0.0).fsignum));
    check("signum of NaN is NaN", isnan(floats(nan, 0.0).fsignum) != 0);
    return failures == 0 ? 0 : 1;
}
