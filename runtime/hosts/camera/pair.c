#include "pair.h"

#include <math.h>
#include <string.h>

static const double share = 0.6;
#define NEVER_NS INT64_MAX

void pair_init(struct pair *p, double period_s, double within_s)
{
    memset(p, 0, sizeof *p);
    p->rhythms[0].period_ns = p->rhythms[1].period_ns = period_s * 1e9;
    p->within_ns = isnan(within_s) ? -1 : (int64_t)(within_s * 1e9);
    p->nearest_ns = NEVER_NS;
}

int64_t pair_most_ns(const struct pair *p)
{
    const double period = fmin(p->rhythms[0].period_ns, p->rhythms[1].period_ns);
    const int64_t most = (int64_t)(share * period);
    return p->within_ns >= 0 && p->within_ns < most ? p->within_ns : most;
}

/* Updates the period. The frame numbers also count frames that did not arrive here. A single gap,
 * however long, changes the period by at most a tenth. */
static void follow(struct rhythm *r, const struct fresh *fresh)
{
    if (fresh->count == 0 || (r->has_any && fresh->numbers[0] <= r->number))
        return;
    if (r->has_any && fresh->captured_ns[0] > r->captured_ns) {
        const double period = (double)(fresh->captured_ns[0] - r->captured_ns) /
                              (double)(fresh->numbers[0] - r->number);
        const double most = 0.1 * r->period_ns;
        r->period_ns += fmax(-most, fmin(most, 0.2 * (period - r->period_ns)));
    }
    r->captured_ns = fresh->captured_ns[0];
    r->number = fresh->numbers[0];
    r->has_any = true;
}

static int64_t distance_ns(int64_t a, int64_t b)
{
    return a > b ? a - b : b - a;
}

/* Returns the frame closest to a time. */
static size_t nearest_of(const struct fresh *fresh, int64_t captured_ns)
{
    size_t nearest = 0;
    for (size_t k = 1; k < fresh->count; k++)
        if (distance_ns(fresh->captured_ns[k], captured_ns) <
            distance_ns(fresh->captured_ns[nearest], captured_ns))
            nearest = k;
    return nearest;
}

/* Chooses two frames that form a pair, and computes how far apart they are; returns false if there
 * is no pair. */
static bool choose(struct pair *p, const struct fresh fresh[2], size_t chosen[2], int64_t *apart_ns)
{
    for (size_t i = 0; fresh[1].count > 0 && i < fresh[0].count; i++) {
        const int64_t captured_ns = fresh[0].captured_ns[i];
        const size_t k = nearest_of(&fresh[1], captured_ns);
        *apart_ns = distance_ns(captured_ns, fresh[1].captured_ns[k]);
        chosen[0] = i;
        chosen[1] = k;
        if (*apart_ns <= pair_most_ns(p) && nearest_of(&fresh[0], fresh[1].captured_ns[k]) == i)
            return true;
        if (*apart_ns < p->nearest_ns)
            p->nearest_ns = *apart_ns;
    }
    return false;
}

/* Takes the chosen frame. If the writer has published more frames in the meantime, finds the frame
 * again by its number. Returns NULL if the writer has already reused the frame's memory. */
static const struct captured *take_number(struct buffers *b, struct fresh *fresh, size_t chosen)
{
    const uint32_t number = fresh->numbers[chosen];
    for (;;) {
        const struct captured *frame = buffers_take_one(b, fresh, chosen);
        if (frame != NULL)
            return frame;
        *fresh = buffers_look(b);
        for (chosen = 0; chosen < fresh->count && fresh->numbers[chosen] != number; chosen++)
            ;
        if (chosen == fresh->count)
            return NULL;
    }
}

bool pair_take(struct pair *p, struct buffers *const buffers[2], const struct captured *frames[2])
{
    struct fresh fresh[2];
    size_t chosen[2];
    int64_t apart_ns;
    for (int i = 0; i < 2; i++) {
        fresh[i] = buffers_look(buffers[i]);
        follow(&p->rhythms[i], &fresh[i]);
    }
    if (!choose(p, fresh, chosen, &apart_ns))
        return false;
    for (int i = 0; i < 2; i++)
        if ((frames[i] = take_number(buffers[i], &fresh[i], chosen[i])) == NULL)
            return false;
    p->count++;
    p->apart_ns += (double)apart_ns;
    p->most_ns = apart_ns > p->most_ns ? apart_ns : p->most_ns;
    p->nearest_ns = NEVER_NS;
    return true;
}
