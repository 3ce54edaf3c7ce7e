#include "by_hand.h"
#include "time_by_hand.h"

static const int64_t back_up_ns = 1000000000;
static const double distance = 0.5, k_side = 0.8, k_slope = 0.3;
static const double free_way = 0.6;

/* Each mode's first output is in the instant in which the previous mode ends. Edges at a mode's
 * first instant do not count. */

static void follow(const struct by_hand *self, const struct modes_input *in,
                   struct modes_output *out)
{
    out->speed = 0.3;
    out->turn = k_side * (in->side - distance) - k_slope * self->side_slope;
}

static void back_up(struct modes_output *out)
{
    out->speed = -0.2;
    out->turn = 0.0;
}

static void turn(struct modes_output *out)
{
    out->speed = 0.0;
    out->turn = 0.8;
}

static void start_following(struct by_hand *self, const struct modes_input *in)
{
    self->mode = FOLLOW;
    self->side_before = in->side;
    self->side_slope = 0.0;
    self->condition_before = in->bump;
}

void by_hand_reset(struct by_hand *self)
{
    self->side_before = 0.0;
    self->side_slope = 0.0;
    self->backing_ns = 0;
    self->mode = FOLLOW;
    self->started = false;
    self->condition_before = true;
}

void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt, const struct modes_input *in,
                  struct modes_output *out)
{
    if (!self->started) {
        self->started = true;
        start_following(self, in);
        follow(self, in, out);
        return;
    }
    switch (self->mode) {
    case FOLLOW:
        if (in->bump && !self->condition_before) {
            self->mode = BACK_UP;
            self->backing_ns = 0;
            back_up(out);
            break;
        }
        self->condition_before = in->bump;
        if (dt_ns > 0)
            self->side_slope = (in->side - self->side_before) / dt;
        self->side_before = in->side;
        follow(self, in, out);
        break;
    case BACK_UP:
        self->backing_ns += dt_ns;
        if (self->backing_ns >= back_up_ns) {
            self->mode = TURN;
            self->condition_before = in->front > free_way;
            turn(out);
            break;
        }
        back_up(out);
        break;
    default: /* TURN */
        if (in->front > free_way && !self->condition_before) {
            start_following(self, in);
            follow(self, in, out);
            break;
        }
        self->condition_before = in->front > free_way;
        turn(out);
        break;
    }
}

void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct modes_input *in,
                             struct modes_output *out)
{
    const int64_t ns = nanoseconds(dt);
    by_hand_step(self, ns, (double)ns / 1e9, in, out);
}
