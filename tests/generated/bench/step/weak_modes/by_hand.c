#include "by_hand.h"
#include "time_by_hand.h"

#include <math.h>

/* Limits y to ±most; NaN if y is NaN. */
static inline double limit(double most, double y)
{
    const double high = y < most ? y : most;
    return isnan(y) ? y : high > -most ? high : -most;
}

void by_hand_reset(struct by_hand *self)
{
    self->side_before = 0.0;
    self->slope = 0.0;
    self->since_ns = 0;
    self->mode = FOLLOW;
    self->started = false;
    self->may_leave = false;
}

static void go(struct by_hand *self, enum by_hand_mode mode)
{
    self->mode = (uint8_t)mode;
    self->since_ns = 0;
}

void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt, const struct weak_modes_input *in,
                  struct weak_modes_output *out)
{
    if (dt > 0.0)
        self->slope = (in->side - self->side_before) / dt;
    self->side_before = in->side;
    switch (self->mode) {
    case FOLLOW:
        out->speed = limit(0.5, in->front - 0.6);
        out->turn = limit(0.24, in->side - 0.6) - self->slope;
        if (self->may_leave) {
            if (in->bump)
                go(self, BACK_UP);
            else if (in->front < 0.3)
                go(self, TURN_AWAY);
        }
        self->may_leave = true;
        break;
    case BACK_UP:
        out->speed = -0.2;
        out->turn = 0.0;
        self->since_ns += dt_ns;
        if (self->since_ns >= 1000000000)
            go(self, TURN_AWAY);
        break;
    default: /* TURN_AWAY */
        out->speed = 0.0;
        out->turn = 0.8;
        self->since_ns += dt_ns;
        if (self->since_ns >= 500000000 && in->front > 0.5)
            go(self, FOLLOW);
        break;
    }
}

void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct weak_modes_input *in,
                             struct weak_modes_output *out)
{
    const int64_t ns = self->started ? nanoseconds(dt) : 0;
    self->started = true;
    by_hand_step(self, ns, (double)ns / 1e9, in, out);
}
