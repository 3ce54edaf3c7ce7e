/* Wraps Copilot's program as a step with the usual interface. */
#include "by_hand.h"
#include "copilot.h"

double dt, side, front;
bool bump;
static struct modes_output *output;

void command(double speed, double turn)
{
    output->speed = speed;
    output->turn = turn;
}

/* Copilot's program cannot be restarted. */
void by_hand_reset(struct by_hand *self)
{
    (void)self;
}

void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt_s, const struct modes_input *in,
                  struct modes_output *out)
{
    (void)self;
    (void)dt_ns;
    dt = dt_s;
    bump = in->bump;
    side = in->side;
    front = in->front;
    output = out;
    step();
}
