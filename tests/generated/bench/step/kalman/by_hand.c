#include "by_hand.h"

#include <math.h>

static const double sonar_noise = 0.0004;

void by_hand_reset(struct by_hand *self)
{
    self->offset = 0.5;
    self->heading = 0.0;
    self->var_offset = 0.1;
    self->covariance = 0.0;
    self->var_heading = 0.05;
}

void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt, const struct kalman_input *in,
                  struct kalman_output *out)
{
    const double went = in->went, turned = in->turned;
    double offset = self->offset + went * self->heading;
    double heading = self->heading + turned;
    double var_offset = self->var_offset + 2.0 * went * self->covariance +
                        went * went * self->var_heading + 0.0001 * fabs(went);
    double covariance = self->covariance + went * self->var_heading;
    double var_heading = self->var_heading + 0.01 * fabs(turned) + 0.001 * fabs(went);
    const double surprise = in->wall - offset;
    (void)dt_ns;
    (void)dt;
    if (fabs(surprise) < 0.5) {
        const double total = var_offset + sonar_noise;
        const double gain_offset = var_offset / total;
        const double gain_heading = covariance / total;
        offset += gain_offset * surprise;
        heading += gain_heading * surprise;
        var_offset = (1.0 - gain_offset) * var_offset;
        var_heading -= gain_heading * covariance;
        covariance = (1.0 - gain_offset) * covariance;
    }
    self->offset = offset;
    self->heading = heading;
    self->var_offset = var_offset;
    self->covariance = covariance;
    self->var_heading = var_heading;
    out->offset = offset;
    out->heading = heading;
    out->varOffset = var_offset;
    out->covariance = covariance;
    out->varHeading = var_heading;
}

void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct kalman_input *in,
                             struct kalman_output *out)
{
    (void)dt;
    by_hand_step(self, 0, 0.0, in, out);
}
