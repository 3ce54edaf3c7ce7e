#include "by_hand.h"
#include "time_by_hand.h"

#include <math.h>

static const double kp = 2.0, ki = 0.3, kd = 0.1, largest = 1.0;

void by_hand_reset(struct by_hand *self)
{
    self->total = 0.0;
    self->growth = 0.0;
    self->before = 0.0;
    self->usual = 0.0;
    self->slope = 0.0;
    self->started = false;
}

void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt, const struct pid_input *in,
                  struct pid_output *out)
{
    const double error = in->value;
    double wanted;
    (void)dt_ns;
    if (!self->started) {
        self->started = true;
    } else if (dt > 0) {
        /* Limit the step, so that the integral does not grow by a whole outage. */
        const double most = fmax(0.2, 2.0 * self->usual);
        const double step = self->usual > 0 && dt > most ? most : dt;
        self->total = fmax(-largest, fmin(largest, self->total + self->growth * step));
        self->usual = step;
        self->slope = (error - self->before) / dt;
    }
    self->before = error;
    wanted = kp * error + self->total + kd * self->slope;
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
