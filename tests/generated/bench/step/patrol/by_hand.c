#include "by_hand.h"
#include "time_by_hand.h"

static const int64_t back_up_ns = 1000000000, wait_ns = 500000000;
static const double distance = 0.5, k_side = 0.8;
static const double free_way = 0.6;

/* Each state's first output is in the instant in which the previous state ends. Edges at a
 * state's first instant do not count. */

static void follow(const struct patrol_input *in, struct patrol_output *out)
{
    out->speed = 0.3;
    out->turn = k_side * (in->side - distance);
}

static void command(struct patrol_output *out, double speed, double turn)
{
    out->speed = speed;
    out->turn = turn;
}

void by_hand_reset(struct by_hand *self)
{
    self->since_ns = 0;
    self->state = FOLLOW;
    self->started = false;
    self->condition_before = true;
}

void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt, const struct patrol_input *in,
                  struct patrol_output *out)
{
    (void)dt;
    if (!self->started) {
        self->started = true;
        self->condition_before = in->bump;
        follow(in, out);
        return;
    }
    switch (self->state) {
    case FOLLOW:
        if (in->bump && !self->condition_before) {
            self->state = BACK_UP;
            self->since_ns = 0;
            command(out, -0.2, 0.0);
            break;
        }
        self->condition_before = in->bump;
        follow(in, out);
        break;
    case BACK_UP:
        self->since_ns += dt_ns;
        if (self->since_ns >= back_up_ns) {
            self->state = WAIT;
            self->since_ns = 0;
            command(out, 0.0, 0.0);
            break;
        }
        command(out, -0.2, 0.0);
        break;
    case WAIT:
        self->since_ns += dt_ns;
        if (self->since_ns >= wait_ns) {
            self->state = TURN;
            self->condition_before = in->front > free_way;
            command(out, 0.0, 0.8);
            break;
        }
        command(out, 0.0, 0.0);
        break;
    default: /* TURN */
        if (in->front > free_way && !self->condition_before) {
            self->state = FOLLOW;
            self->condition_before = in->bump;
            follow(in, out);
            break;
        }
        self->condition_before = in->front > free_way;
        command(out, 0.0, 0.8);
        break;
    }
}

void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct patrol_input *in,
                             struct patrol_output *out)
{
    by_hand_step(self, nanoseconds(dt), 0.0, in, out);
}
