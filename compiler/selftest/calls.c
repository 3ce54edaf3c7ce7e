/* What foreign.frob calls. */
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

void mean_reset(struct mean_state *self)
{
    self->sum = 0.0;
    self->count = 0;
}

void mean_step(struct mean_state *self, double dt, const struct mean_input *in,
               struct mean_output *out)
{
    (void)dt;
    self->sum += in->value;
    self->count++;
    out->value = self->sum / self->count;
}
