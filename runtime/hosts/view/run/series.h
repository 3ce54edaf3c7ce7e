/* series.h -- the values of a signal over many instants, as the points of a plot. */
#ifndef FROB_VIEW_SERIES_H
#define FROB_VIEW_SERIES_H

#include "replay.h"

/* Number of signals whose values are cached. The cache keeps the most recently used signals. */
#define SERIES_KEPT 32

struct series {
    struct replay *replay;
    struct kept_series {
        const struct signal *signal;
        double *numbers; /* the value at each instant */
        size_t count;    /* number of instants for which values have been computed */
        size_t room;     /* number of instants for which there is space */
        unsigned long used;
    } kept[SERIES_KEPT];
    unsigned long uses;
};

void series_start(struct series *series, struct replay *replay);
void series_end(struct series *series);

/* Discards all values, because the program's outputs turned out to differ from the recorded
 * ones. */
void series_forget(struct series *series);

/* Returns the values of a signal at all instants (see signal_number); NULL if memory runs out. They
 * stay valid until SERIES_KEPT / 2 other signals have been requested or the recording has grown. */
const double *series_of(struct series *series, const struct signal *signal);

/* Calls `visit`, in order, for the instants needed to plot `numbers` in approximately `width`
 * columns, from instant `from` up to, but not including, `to`. If each column has at least five
 * instants, these are the first and last instants of each column, and those with its least and
 * greatest values; otherwise, they are all instants. */
void series_visit(const double *numbers, size_t from, size_t to, size_t width,
                  void (*visit)(void *context, size_t k), void *context);

#endif
