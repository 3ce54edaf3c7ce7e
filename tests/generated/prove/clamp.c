/* Proves properties of the clamp (runtime/core/robot.c) for any output and any limits up to
 * MOST: afterwards the output is finite and at most MOST, and if one number was not finite, all
 * are zero. This program is only analysed, never run. */
#include <__fc_builtin.h>
#include <float.h>
#include <math.h>
#include <stddef.h>

/* A definition of isfinite that the analysis understands: the library's is only declared, so the
 * analysis learns nothing about the number from it. */
#undef isfinite
#define isfinite(x) ((x) == (x) && (x) >= -DBL_MAX && (x) <= DBL_MAX)

#include "core/robot.c"

#define MOST 5.0

struct output {
    double forward;
    bool light;
    double turn;
    double other;
};

static const size_t drives[] = { offsetof(struct output, forward), offsetof(struct output, turn) };

static double most(const void *device, size_t i)
{
    (void)device;
    (void)i;
    return Frama_C_double_interval(0.0, MOST);
}

static const struct frob_driver driver = { .drives = drives, .drive_count = 2, .most = most };

int main(void)
{
    struct output output;
    Frama_C_make_unknown((char *)&output, sizeof output);
    frob_robot_limit(&driver, NULL, &output);
    /* The conversion raises an alarm unless the number is finite. */
    volatile int forward = (int)output.forward, turn = (int)output.turn;
    (void)forward;
    (void)turn;
    if (output.forward > MOST || output.forward < -MOST || output.turn > MOST ||
        output.turn < -MOST)
        /*@ assert \false; */;

    Frama_C_make_unknown((char *)&output, sizeof output);
    output.turn = NAN;
    frob_robot_limit(&driver, NULL, &output);
    if (output.forward != 0.0 || output.turn != 0.0)
        /*@ assert \false; */;
    return 0;
}
