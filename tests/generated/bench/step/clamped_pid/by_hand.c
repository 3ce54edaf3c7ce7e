#include "by_hand.h"
#include "time_by_hand.h"

static inline double limit(double most, double y)
{
    const double high = y < most ? y : most;
    return high > -most ? high : -most;
}

void by_hand_reset(struct by_hand *self)
{
    self->error_before = 0.0;
    self->sum = 0.0;
    self->started = false;
}

void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt,
                  const struct clamped_pid_input *in, struct clamped_pid_output *out)
{
    const double error = in->f1 - in->f2;
    const double slope = self->started ? (error - self->error_before) / dt : 0.0;
    const double sum = self->sum + error * dt;
    const double raw = 1.2 * error + 0.4 * sum + 0.05 * slope;
    const double output = limit(1.0, raw);
    (void)dt_ns;
    if (raw == output || error * raw < 0.0)
        self->sum = sum;
    self->error_before = error;
    self->started = true;
    out->value = output;
}

void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct clamped_pid_input *in,
                             struct clamped_pid_output *out)
{
    by_hand_step(self, 0, whole_nanoseconds(dt), in, out);
}
