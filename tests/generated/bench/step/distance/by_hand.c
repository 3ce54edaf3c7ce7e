#include "by_hand.h"
#include "time_by_hand.h"

#include <math.h>

static const double sin_theta_max = 0.479425538604203; /* sin 0.5 */

/* Limits y to ±most, or to 0 if most is negative; NaN if either is NaN. */
static inline double limit(double most, double y)
{
    const double largest = most < 0.0 ? 0.0 : most;
    const double high = y < largest ? y : largest;
    return isnan(y) ? y : high > -largest ? high : -largest;
}

void by_hand_reset(struct by_hand *self)
{
    self->side_before = 0.0;
    self->slope = 0.0;
    self->started = false;
}

void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt, const struct distance_input *in,
                  struct distance_output *out)
{
    const double v_curr = in->f1, front = in->f2, side = in->f3;
    (void)dt_ns;
    if (dt > 0.0)
        self->slope = (side - self->side_before) / dt;
    self->side_before = side;
    out->f1 = limit(0.5, front - 0.6);
    out->f2 = limit(sin_theta_max * v_curr, side - 0.6) - self->slope;
}

void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct distance_input *in,
                             struct distance_output *out)
{
    const double whole = self->started ? whole_nanoseconds(dt) : 0.0;
    self->started = true;
    by_hand_step(self, 0, whole, in, out);
}
