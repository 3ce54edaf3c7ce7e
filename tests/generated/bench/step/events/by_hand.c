#include "by_hand.h"
#include "time_by_hand.h"

static const int64_t bounce_ns = 30000000, period_ns = 100000000;

void by_hand_reset(struct by_hand *self)
{
    self->at_press = 0.0;
    self->sampled = 0.0;
    self->time_ns = 0;
    self->differs_since_ns = 0;
    self->sampled_ns = 0;
    self->presses = 0;
    self->started = false;
    self->button = false;
    self->differs = false;
    self->on = false;
}

void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt, const struct events_input *in,
                  struct events_output *out)
{
    (void)dt;
    if (!self->started) {
        self->started = true;
        self->button = in->button;
    } else {
        self->time_ns += dt_ns;
        if (in->button == self->button) {
            self->differs = false;
        } else {
            if (!self->differs) {
                self->differs = true;
                self->differs_since_ns = self->time_ns;
            }
            if (self->time_ns - self->differs_since_ns >= bounce_ns) {
                self->button = in->button;
                self->differs = false;
                if (self->button) {
                    self->on = !self->on;
                    self->presses++;
                    self->at_press = in->temperature;
                }
            }
        }
        if (self->time_ns - self->sampled_ns >= period_ns) {
            self->sampled_ns = self->time_ns - (self->time_ns - self->sampled_ns) % period_ns;
            self->sampled = in->temperature;
        }
    }
    out->lamp = self->on ? 1.0 : 0.0;
    out->presses = (double)self->presses;
    out->atPress = self->at_press;
    out->sampled = self->sampled;
}

void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct events_input *in,
                             struct events_output *out)
{
    by_hand_step(self, nanoseconds(dt), 0.0, in, out);
}
