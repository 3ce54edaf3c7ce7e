/* The functions that foreign.frob calls. Each result comes from a single operation, so rounding it
 * to single precision yields the same result as a float operation. */
#include "calls.h"
#include "foreign.h"

struct place {
    int32_t number;
};

void selftest_span(double from, double to, struct span *result)
{
    result->from = from;
    result->to = to;
}

double selftest_width(const struct span *span)
{
    return span->to - span->from;
}

const struct place *selftest_place(int32_t number)
{
    static const struct place places[2] = { { 0 }, { 1 } };
    return &places[number % 2 != 0];
}

int32_t selftest_number(const struct place *place)
{
    return place->number;
}

void selftest_higher(const struct frob_maybe_float *a, const double *b,
                     struct frob_maybe_float *result)
{
    *result = *a;
    result->f0 += b[1];
}

void sway_reset(struct sway_state *self)
{
    self->last = 0.0;
    self->count = 0;
}

void sway_step(struct sway_state *self, double dt, const struct sway_input *in,
               struct sway_output *out)
{
    (void)dt;
    out->f1 = in->value - self->last;
    out->f2 = ++self->count;
    self->last = in->value;
}
