/* Tests that time counts whole nanoseconds from the first instant on. */
#include "clock.h"
#include <math.h>
#include <stdio.h>

static int failures;

static void check(const char *name, bool ok)
{
    printf("%s %s\n", ok ? "ok" : "FAIL", name);
    failures += ok ? 0 : 1;
}

static struct clock_output step(struct clock_state *state, double dt, double x)
{
    struct clock_input in;
    struct clock_output out;
    in.value = x;
    clock_step(state, dt, &in, &out);
    return out;
}

/* The time after a first instant and one more with this dt. */
static double after(double dt)
{
    struct clock_state state;
    clock_reset(&state);
    step(&state, 0.0, 0.0);
    return step(&state, dt, 0.0).f1;
}

int main(void)
{
    struct clock_state state;
    struct clock_output out;
    int k;

    clock_reset(&state);
    out = step(&state, 5.0, 3.0);
    check("dt of the first instant is not looked at",
          out.f1 == 0.0 && out.f2 == 0.0 && out.f3 == 0.0);
    out = step(&state, 0.5, 4.0);
    check("time adds up", out.f1 == 0.5);
    check("an integral adds dt times the last input", out.f2 == 1.5);
    check("a derivative", out.f3 == 2.0);
    out = step(&state, 0.0, 9.0);
    check("a derivative stays where dt is 0", out.f3 == 2.0);
    out = step(&state, 1.0, 10.0);
    check("and goes on from the last input", out.f3 == 1.0);

    clock_reset(&state);
    out = step(&state, 0.0, 0.0);
    for (k = 0; k < 10; k++) {
        out = step(&state, 0.1, 0.0);
    }
    check("ten steps of 0.1 s are 1 s", out.f1 == 1.0);

    check("half a nanosecond rounds to even, down", after(0.5e-9) == 0.0);
    check("one and a half rounds to even, up", after(1.5e-9) == 2e-9);
    check("less than half is 0", after(0.4e-9) == 0.0);
    check("NaN is 0", after((double)NAN) == 0.0);
    check("negative is 0", after(-1.0) == 0.0);
    check("infinity is 1e9 s", after((double)INFINITY) == 1e9);
    check("more than 1e9 s is 1e9 s", after(2e9) == 1e9);
    check("large and exact", after(123456789.0) == 123456789.0);

    clock_reset(&state);
    step(&state, 0.0, 1.0);
    out = step(&state, 0.1 + 0.3e-9, 2.0);
    check("an integral adds whole nanoseconds", out.f2 == 0.1);
    check("a derivative divides by whole nanoseconds", out.f3 == 1.0 / 0.1);
    check("minus zero is zero", step(&state, -0.0, 9.0).f3 == 1.0 / 0.1);

    clock_reset(&state);
    for (k = 0; k < 20; k++) {
        out = step(&state, 1e9, 0.0);
    }
    check("time stops at its end and does not wrap", out.f1 == (double)INT64_MAX / 1e9);
    return failures == 0 ? 0 : 1;
}
