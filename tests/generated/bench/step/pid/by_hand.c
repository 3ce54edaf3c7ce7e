#include "by_hand.h"
#include "time_by_hand.h"

#include <math.h>

static const double kp = 2.0, ki = 0.3, kd = 0.1, largest = 1.0;

void by_hand_reset(struct by_hand *self)
{
    self->total = 0.0;
    self->growth = 0.0;
    self->before = 0.0;
    self->since = 0.0;
    self->usual = 0.0;
    self->slope = 0.0;
    self->known = false;
    self->started = false;
}

void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt, const struct pid_input *in,
                  struct pid_output *out)
{
    const double error = in->value;
    double slope = self->slope, wanted;
    (void)dt_ns;
    if (!self->started) {
        self->started = true;
    } else if (dt > 0) {
        /* Limit the step, so that the integral does not grow by a whole outage. */
        const double most = fmax(0.2, 2.0 * self->usual);
        const double step = self->usual > 0 && dt > most ? most : dt;
        self->total = fmax(-largest, fmin(largest, self->total + self->growth * step));
        self->usual = step;
        self->since += dt;
    }
    /* A NaN at one instant must not spoil the slope of later ones. */
    if (!isfinite(error)) {
        slope = NAN;
    } else {
        if (self->known && self->since > 0) {
            slope = (error - self->before) / self->since;
            if (isfinite(slope))
                self->slope = slope;
        }
        self->before = error;
        self->since = 0.0;
        self->known = true;
    }
    wanted = kp * error + self->total + kd * slope;
    self->growth = fabs(wanted) <= largest || ki * error * wanted <= 0 ? ki * error : 0.0;
    if (wanted > largest)
        out->value = largest;
    else if (wanted < -largest)
        out->value = -largest;
    else
        out->value = wanted;
}

void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct pid_input *in,
                             struct pid_output *out)
{
    by_hand_step(self, 0, whole_nanoseconds(dt), in, out);
}
