/* watch.h -- the results of a program's assertions for the instants run so far, and the instants at
 * which each assertion was violated. */
#ifndef FROB_VIEW_WATCH_H
#define FROB_VIEW_WATCH_H

#include "../../common/claims.h"

struct watched {
    /* Alternating starts and ends of violations. A violation lasts up to, but not including, its
     * end. A violation that still continues has no end yet. */
    size_t *ends;
    size_t count, room;
};

struct watch {
    struct claims claims;
    struct watched *each; /* in the order of the program's claims */
};

/* If memory runs out, prints a line on standard error and returns false. */
bool watch_start(struct watch *watch, const struct frob_program *program);
void watch_end(struct watch *watch);

/* Evaluates the output of the next instant. */
void watch_see(struct watch *watch, size_t k, int64_t time_ns, const void *output);

#endif
