/* watch.h -- what became of a program's assertions as far as it has been run, and for which
 * instants each was violated. */
#ifndef FROB_VIEW_WATCH_H
#define FROB_VIEW_WATCH_H

#include "../../common/claims.h"

struct watched {
    size_t *ends; /* violated from an instant to before another, and so on in turn; what lasts
                   * has no end yet */
    size_t count, room;
};

struct watch {
    struct claims claims;
    struct watched *each; /* in the order of the program's claims */
};

/* False without memory, with a line on standard error. */
bool watch_start(struct watch *watch, const struct frob_program *program);
void watch_end(struct watch *watch);

/* The output of the next instant. */
void watch_see(struct watch *watch, size_t k, int64_t time_ns, const void *output);

#endif
