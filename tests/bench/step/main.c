/* Generated steps beside steps by hand: see harness.h. */
#include "harness.h"
#include "pid.h"
#include "pid_by_hand.h"
#include "wall_follow.h"
#include "wall_follow_by_hand.h"

#include <stdint.h>

/* What both get: whole nanoseconds around 20 ms, and inputs that reach the
 * limits part of the time. */
static double dt[INSTANTS];
static struct wall_follow_input follow_in[INSTANTS];
static struct pid_input error_in[INSTANTS];

static struct wall_follow_state follow;
static struct wall_follow_output follow_out[INSTANTS];
static struct wall_follow_by_hand follow_hand;
static double v_hand[INSTANTS], omega_hand[INSTANTS];

static struct pid_state pid;
static struct pid_output pid_out[INSTANTS];
static struct pid_by_hand pid_hand;
static double pid_out_hand[INSTANTS];

static void make_inputs(void)
{
    for (size_t i = 0; i < INSTANTS; i++) {
        dt[i] = (double)(long)(19e6 + 2e6 * bench_random()) / 1e9;
        follow_in[i].f1 = 0.4 * bench_random();
        follow_in[i].f2 = 0.1 + bench_random();
        follow_in[i].f3 = 0.1 + 0.3 * bench_random();
        error_in[i].value = 1.2 * (bench_random() - 0.5);
    }
}

/* dt to the nearest nanosecond, as a careful person writes it. */
static double whole_nanoseconds(double seconds)
{
    return seconds > 0 ? (double)(int64_t)(seconds * 1e9 + 0.5) / 1e9 : 0.0;
}

static void follow_pass(void)
{
    wall_follow_reset(&follow);
    for (size_t i = 0; i < INSTANTS; i++)
        wall_follow_step(&follow, dt[i], &follow_in[i], &follow_out[i]);
}

static void follow_hand_instant(size_t i, double dt_i)
{
    wall_follow_by_hand_step(&follow_hand, dt_i, follow_in[i].f1, follow_in[i].f2, follow_in[i].f3,
                             &v_hand[i], &omega_hand[i]);
}

static void follow_hand_pass(void)
{
    wall_follow_by_hand_reset(&follow_hand);
    for (size_t i = 0; i < INSTANTS; i++)
        follow_hand_instant(i, whole_nanoseconds(dt[i]));
}

static void follow_hand_pass_as_it_comes(void)
{
    wall_follow_by_hand_reset(&follow_hand);
    for (size_t i = 0; i < INSTANTS; i++)
        follow_hand_instant(i, dt[i]);
}

static void pid_pass(void)
{
    pid_reset(&pid);
    for (size_t i = 0; i < INSTANTS; i++)
        pid_step(&pid, dt[i], &error_in[i], &pid_out[i]);
}

static void pid_hand_pass(void)
{
    pid_by_hand_reset(&pid_hand);
    for (size_t i = 0; i < INSTANTS; i++)
        pid_out_hand[i] = pid_by_hand_step(&pid_hand, whole_nanoseconds(dt[i]), error_in[i].value);
}

static void pid_hand_pass_as_it_comes(void)
{
    pid_by_hand_reset(&pid_hand);
    for (size_t i = 0; i < INSTANTS; i++)
        pid_out_hand[i] = pid_by_hand_step(&pid_hand, dt[i], error_in[i].value);
}

int main(void)
{
    make_inputs();
    bench_compare(&(struct bench_row){"wall_follow", follow_pass, follow_hand_pass,
                                      follow_hand_pass_as_it_comes, sizeof follow,
                                      sizeof follow_hand});
    bench_compare(&(struct bench_row){"pid", pid_pass, pid_hand_pass, pid_hand_pass_as_it_comes,
                                      sizeof pid, sizeof pid_hand});
    for (size_t i = 0; i < INSTANTS; i++) {
        bench_equal("wall_follow", i, follow_out[i].f1, v_hand[i]);
        bench_equal("wall_follow", i, follow_out[i].f2, omega_hand[i]);
        bench_equal("pid", i, pid_out[i].value, pid_out_hand[i]);
    }
    return 0;
}
