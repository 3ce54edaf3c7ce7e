/* Tests drivers/steps.h, which rounds speeds to whole steps. */
#include "drivers/steps.h"

#include "check.h"

#include <math.h>
#include <string.h>

#define PERIOD_S 0.02

/* The mean number over `count` commands, `period_s` apart. */
static double mean(struct frob_steps *s, double wanted, int count, double period_s)
{
    double way = 0.0, now_s = s->since_s;
    for (int i = 0; i < count; i++) {
        now_s += period_s;
        *s = frob_steps_next(s, wanted, 1000.0, now_s);
        way += s->sent * period_s;
    }
    return way / (count * period_s);
}

static void means_are_what_is_wanted(void)
{
    int wrong = 0, far = 0;
    for (int k = -1999; k < 2000; k++) {
        struct frob_steps s = { 0.0, 0.0, 0.0, 0.0 };
        double wanted = k * 1.234e-3;
        for (int i = 0; i < 5; i++)
            if (fabs(mean(&s, wanted, 400, PERIOD_S) - wanted) > 1.0 / 400)
                wrong++;
        if (s.sent != floor(wanted) && s.sent != ceil(wanted))
            far++;
    }
    check(wrong == 0, "the mean of 400 commands is what is wanted, to a command's step");
    check(far == 0, "each number is next to what is wanted");
}

/* Sends commands 10 to 60 ms apart, with irregular intervals. */
static void means_hold_at_any_pace(void)
{
    struct frob_steps s = { 0.0, 0.0, 0.0, 0.0 };
    unsigned long random = 1;
    double now_s = 0.0, way = 0.0, start_s = 0.0;
    s = frob_steps_next(&s, 0.31, 1000.0, now_s);
    for (int i = 0; i < 20000; i++) {
        double held_s;
        random = (random * 1103515245UL + 12345UL) & 0x7FFFFFFFUL;
        held_s = 0.01 + 0.05 * (double)(random >> 8) / (double)(0x7FFFFFFFUL >> 8);
        way += s.sent * held_s;
        now_s += held_s;
        s = frob_steps_next(&s, 0.31, 1000.0, now_s);
    }
    check_near(way / (now_s - start_s), 0.31, 1e-3, "how long each command is held counts");
}

static void rest_is_rest(void)
{
    struct frob_steps s = { 0.0, 0.0, 0.0, 0.0 };
    mean(&s, 0.4999, 100, PERIOD_S);
    s = frob_steps_next(&s, 0.0, 1000.0, s.since_s + PERIOD_S);
    check(s.sent == 0.0 && s.owed == 0.0 && s.missing == 0.0, "at zero nothing is owed");
    mean(&s, 0.4999, 3, PERIOD_S);
    s = frob_steps_next(&s, 0.1, 1000.0, s.since_s + 2.0);
    check(s.sent == 0.0 && s.owed == 0.0, "after a pause nothing is owed");
}

static void no_command_is_in_the_other_direction(void)
{
    struct frob_steps s = { 0.0, 0.0, 0.0, 0.0 };
    int wrong = 0;
    for (int i = 0; i < 1000; i++) {
        double wanted = (i / 7) % 2 == 0 ? 0.49 : -1e-300;
        s = frob_steps_next(&s, wanted, 1000.0, s.since_s + PERIOD_S);
        if (s.sent != 0.0 && (s.sent > 0.0) != (wanted > 0.0))
            wrong++;
    }
    check(wrong == 0, "no number has another sign than what is wanted");
}

static void limits_hold(void)
{
    struct frob_steps s = { 0.0, 0.0, 0.0, 0.0 };
    double greatest = 0.0;
    for (int i = 0; i < 1000; i++) {
        s = frob_steps_next(&s, 393.0 + 0.7 * i / 999.0, 393.7, s.since_s + PERIOD_S);
        greatest = fmax(greatest, s.sent);
    }
    check(greatest == 393.0 && s.owed == 0.0,
          "no number is over the limit, and nothing is owed there");
    s = frob_steps_next(&s, -1e9, 393.7, s.since_s + PERIOD_S);
    check(s.sent == -393.0, "nor under it");
    s = frob_steps_next(&s, 300.0, 299.99999999999994, s.since_s + PERIOD_S);
    check(s.sent == 300.0, "a limit that is whole but for rounding is whole");
}

/* Whole numbers from a firmware leave only a negligible rounding error. */
static void whole_numbers_stay(void)
{
    struct frob_wire wire = { false, { 1e-3, 0.017453292519943295 }, { 1.2, 5.3 }, 0.0 };
    struct frob_wire_numbers n;
    int wrong = 0;
    memset(&n, 0, sizeof n);
    for (int i = 0; i < 20000; i++) {
        int forward = i % 1200, turn = i % 300;
        n = frob_wire_next(&wire, &n, forward / 1000.0, turn * 0.017453292519943295, i * 0.005);
        if (n.number[0].sent != forward || n.number[1].sent != turn)
            wrong++;
    }
    check(wrong == 0, "whole numbers are sent as they are");
}

/* If one wheel exceeds the limit, both slow down: on a Create, 0.3 m/s and 4 rad/s would be -0.17
 * and 0.77 m/s. */
static void wheels_keep_to_the_curve(void)
{
    struct frob_wire wire = { true, { 1e-3, 1e-3 }, { 0.5, 0.5 }, 0.235 };
    struct frob_wire_numbers n;
    memset(&n, 0, sizeof n);
    n = frob_wire_next(&wire, &n, 0.3, 4.0, 0.02);
    check(n.number[0].sent == -110.0 && n.number[1].sent == 500.0, "wheels are slowed together");
    check_near(frob_wire_forward(&wire, &n), 0.195, 1e-12, "so the speed is what they say");
    check_near(frob_wire_turn(&wire, &n), 0.61 / 0.235, 1e-12, "and the turning");
}

int main(void)
{
    means_are_what_is_wanted();
    means_hold_at_any_pace();
    rest_is_rest();
    no_command_is_in_the_other_direction();
    limits_hold();
    whole_numbers_stay();
    wheels_keep_to_the_curve();
    return check_status();
}
