#include "by_hand.h"
#include "time_by_hand.h"

static const double sin_theta_max = 0.479425538604203; /* sin 0.5 */

static inline double limit(double most, double y)
{
    const double high = y < most ? y : most;
    return high > -most ? high : -most;
}

void by_hand_reset(struct by_hand *self)
{
    self->side_before = 0.0;
    self->started = false;
}

void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt, const struct distance_input *in,
                  struct distance_output *out)
{
    const double v_curr = in->f1, front = in->f2, side = in->f3;
    const double slope = self->started ? (side - self->side_before) / dt : 0.0;
    (void)dt_ns;
    self->started = true;
    self->side_before = side;
    out->f1 = limit(0.5, front - 0.6);
    out->f2 = limit(sin_theta_max * v_curr, side - 0.6) - slope;
}

void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct distance_input *in,
                             struct distance_output *out)
{
    by_hand_step(self, 0, whole_nanoseconds(dt), in, out);
}
