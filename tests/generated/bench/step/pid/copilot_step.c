/* Wraps Copilot's program as a step with the usual interface. */
#include "by_hand.h"
#include "copilot.h"

double dt, err;
static struct pid_output *output;

void command(double value)
{
    output->value = value;
}

/* Copilot's program cannot be restarted. */
void by_hand_reset(struct by_hand *self)
{
    (void)self;
}

void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt_s, const struct pid_input *in,
                  struct pid_output *out)
{
    (void)self;
    (void)dt_ns;
    dt = dt_s;
    err = in->value;
    output = out;
    step();
}
