/* series.h -- a signal over many instants, as the points of a plot. */
#ifndef FROB_VIEW_SERIES_H
#define FROB_VIEW_SERIES_H

#include "replay.h"

/* How many signals have their numbers kept, the last that were asked for. */
#define SERIES_KEPT 32

struct series {
    struct replay *replay;
    struct kept_series {
        const struct signal *signal;
        double *numbers; /* of each instant … */
        size_t count;    /* … up to this, … */
        size_t room;     /* … with room for so many */
        unsigned long used;
    } kept[SERIES_KEPT];
    unsigned long uses;
};

void series_start(struct series *series, struct replay *replay);
void series_end(struct series *series);

/* Forgets all numbers: outputs are not those recorded after all. */
void series_forget(struct series *series);

/* The numbers of a signal at all instants (see signal_number); NULL without memory. Good
 * until SERIES_KEPT / 2 others were asked for, or the recording has grown. */
const double *series_of(struct series *series, const struct signal *signal);

/* Calls `visit` for the instants that make up the plot of `numbers` from instant `from`
 * to before `to` on about `width` columns: where there are more, the first, the least,
 * the greatest and the last of each column, in order. */
void series_visit(const double *numbers, size_t from, size_t to, size_t width,
                  void (*visit)(void *context, size_t k), void *context);

#endif
