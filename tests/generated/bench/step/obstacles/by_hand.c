#include "by_hand.h"

#include <math.h>

static const double along[16] = { -0.98, -0.83, -0.56, -0.20, 0.20,  0.56,  0.83,  0.98,
                                  0.98,  0.83,  0.56,  0.20,  -0.20, -0.56, -0.83, -0.98 };
static const double across[16] = { -0.20, -0.56, -0.83, -0.98, -0.98, -0.83, -0.56, -0.20,
                                   0.20,  0.56,  0.83,  0.98,  0.98,  0.83,  0.56,  0.20 };

void by_hand_reset(struct by_hand *self)
{
    for (int i = 0; i < 16; i++)
        self->near[i] = 3.0;
}

void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt, const struct obstacles_input *in,
                  struct obstacles_output *out)
{
    double back = 0.0, aside = 0.0;
    double nearest = INFINITY; /* a dead sonar (NaN) is never the nearest */
    (void)dt_ns;
    (void)dt;
    for (int i = 0; i < 16; i++) {
        const double before = self->near[i];
        const double d = before + 0.4 * (in->sonar[i] - before);
        self->near[i] = d;
        if (d < nearest)
            nearest = d;
        if (d < 1.0) {
            const double push = 1.0 - d;
            back += along[i] * push;
            aside += across[i] * push;
        }
    }
    if (nearest < 0.2) {
        out->speed = 0.0;
    } else {
        const double v = 0.5 - 0.6 * back;
        out->speed = v > 0.5 ? 0.5 : v < -0.1 ? -0.1 : v;
    }
    out->turn = -1.5 * aside;
}

void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct obstacles_input *in,
                             struct obstacles_output *out)
{
    (void)dt;
    by_hand_step(self, 0, 0.0, in, out);
}
