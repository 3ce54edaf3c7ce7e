#include "by_hand.h"
#include "time_by_hand.h"

static const int64_t drive_ns = 2000000000, turn_ns = 1500000000;
static const double acceleration = 0.4, top_speed = 0.5, slow_speed = 0.1;

void by_hand_reset(struct by_hand *self)
{
    self->speed = 0.0;
    self->since_ns = 0;
    self->started = false;
    self->working = false;
    self->turning = false;
    self->slow = false;
    self->duty_before = true;
    self->close_before = true;
    self->near_before = true;
    self->free_before = true;
}

/* Start the modes. Edges at a mode's first instant do not count. */

static void start_cruise(struct by_hand *self, const struct nested_input *in)
{
    self->slow = false;
    self->speed = 0.0;
    self->near_before = in->front < 0.8;
}

static void start_drive(struct by_hand *self, const struct nested_input *in)
{
    self->turning = false;
    self->since_ns = 0;
    self->close_before = in->front < 0.3;
    start_cruise(self, in);
}

static void drive(struct by_hand *self, int64_t dt_ns, double dt, const struct nested_input *in)
{
    const bool close = in->front < 0.3, near = in->front < 0.8, free = in->front > 1.0;
    self->since_ns += dt_ns;
    if (self->since_ns >= drive_ns || (close && !self->close_before)) {
        self->turning = true;
        self->since_ns = 0;
        return;
    }
    self->close_before = close;
    if (!self->slow) {
        self->speed += dt * acceleration;
        if (near && !self->near_before) {
            self->slow = true;
            self->free_before = free;
        }
        self->near_before = near;
    } else {
        if (free && !self->free_before)
            start_cruise(self, in);
        self->free_before = free;
    }
}

void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt, const struct nested_input *in,
                  struct nested_output *out)
{
    if (in->duty != self->duty_before) {
        self->duty_before = in->duty;
        if (!self->working && in->duty) {
            self->working = true;
            start_drive(self, in);
        } else if (self->working && !in->duty) {
            self->working = false;
        }
    } else if (self->working) {
        if (self->turning) {
            self->since_ns += dt_ns;
            if (self->since_ns >= turn_ns)
                start_drive(self, in);
        } else {
            drive(self, dt_ns, dt, in);
        }
    }
    out->speed = 0.0;
    out->turn = 0.0;
    if (!self->working)
        return;
    if (self->turning)
        out->turn = 0.8;
    else if (self->slow)
        out->speed = slow_speed;
    else
        out->speed = self->speed > top_speed ? top_speed : self->speed;
}

void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct nested_input *in,
                             struct nested_output *out)
{
    const int64_t ns = self->started ? nanoseconds(dt) : 0;
    self->started = true;
    by_hand_step(self, ns, (double)ns / 1e9, in, out);
}
