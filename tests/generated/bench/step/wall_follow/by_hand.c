#include "by_hand.h"
#include "time_by_hand.h"

#include <frob/elementary.h>
#include <math.h>

static const double distance = 0.2;
static const double v_max = 0.4;
static const double theta_max = 20 * 3.14159265358979323846 / 180;
static const double k_front = 1.0, k_side = 0.8, k_turn = 3.0;

/* Limits y to ±x, or to 0 if x is negative; NaN if either is NaN. */
static double limit(double x, double y)
{
    const double most = x < 0.0 ? 0.0 : x;
    const double high = y < most ? y : most;
    return isnan(y) ? y : high > -most ? high : -most;
}

void by_hand_reset(struct by_hand *self)
{
    self->sin_theta_max = frob_sin(theta_max);
    self->s_before = 0.0;
    self->s_dot = 0.0;
    self->started = false;
}

void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt,
                  const struct wall_follow_input *in, struct wall_follow_output *out)
{
    const double v_curr = in->f1, f = in->f2, s = in->f3;
    (void)dt_ns;
    if (dt > 0)
        self->s_dot = (s - self->s_before) / dt;
    self->s_before = s;
    out->f1 = limit(v_max, k_front * (f - distance));
    out->f2 = k_turn * (limit(self->sin_theta_max * v_curr, k_side * (s - distance)) - self->s_dot);
}

void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct wall_follow_input *in,
                             struct wall_follow_output *out)
{
    const double whole = self->started ? whole_nanoseconds(dt) : 0.0;
    self->started = true;
    by_hand_step(self, 0, whole, in, out);
}
