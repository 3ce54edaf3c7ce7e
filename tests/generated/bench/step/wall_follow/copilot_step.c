/* Wraps Copilot's program as a step with the usual interface. */
#include "by_hand.h"
#include "copilot.h"

double dt, v_curr, front, side;
static struct wall_follow_output *output;

void command(double v, double omega)
{
    output->f1 = v;
    output->f2 = omega;
}

/* Copilot's program cannot be restarted. */
void by_hand_reset(struct by_hand *self)
{
    (void)self;
}

void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt_s,
                  const struct wall_follow_input *in, struct wall_follow_output *out)
{
    (void)self;
    (void)dt_ns;
    dt = dt_s;
    v_curr = in->f1;
    front = in->f2;
    side = in->f3;
    output = out;
    step();
}
