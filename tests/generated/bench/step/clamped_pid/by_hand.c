#include "by_hand.h"
#include "time_by_hand.h"

/* Limits y to ±1; NaN if it is NaN. */
static inline double limit(double y)
{
    const double high = y > 1.0 ? 1.0 : y;
    return high < -1.0 ? -1.0 : high;
}

void by_hand_reset(struct by_hand *self)
{
    self->error_before = 0.0;
    self->sum = 0.0;
    self->slope = 0.0;
    self->started = false;
}

void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt,
                  const struct clamped_pid_input *in, struct clamped_pid_output *out)
{
    const double error = in->f1 - in->f2;
    const double sum = self->sum + error * dt;
    double raw, output;
    (void)dt_ns;
    if (dt > 0.0)
        self->slope = (error - self->error_before) / dt;
    raw = 1.2 * error + 0.4 * sum + 0.05 * self->slope;
    output = limit(raw);
    if (raw == output || error * raw < 0.0)
        self->sum = sum;
    self->error_before = error;
    out->value = output;
}

void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct clamped_pid_input *in,
                             struct clamped_pid_output *out)
{
    const double whole = self->started ? whole_nanoseconds(dt) : 0.0;
    self->started = true;
    by_hand_step(self, 0, whole, in, out);
}
