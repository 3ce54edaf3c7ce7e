/* publisher.h -- a run that can be looked at: the memory that it is published in, and the
 * viewer, a process of its own.
 *
 * Whether the viewer looks, is slow, was stopped, or has ended makes no difference to the run. */
#ifndef FROB_HOST_PUBLISHER_H
#define FROB_HOST_PUBLISHER_H

#include "ring.h"

#include <frob/program.h>

struct publisher {
    struct ring ring; /* without memory: nobody is to look */
    const struct frob_program *program;
    unsigned char *input; /* of a program with images, room for one that another process can
                           * read; else NULL */
    uint32_t beats;       /* the last of the viewer's that was heard … */
    int64_t heard_ns;     /* … at this time */
};

/* Starts the viewer, a command that ends with NULL, with `--ring NUMBER` before its other
 * arguments; NULL: nobody is to look. `truth_size`, `permissions`: see ring.h. If it cannot be
 * started there is a warning, and the run goes on. */
void publisher_start(struct publisher *p, const struct frob_program *program, size_t truth_size,
                     unsigned permissions, char *const *viewer);

/* Publishes the next instant. An image is, in place of its address, the key of its frame
 * (frames.h), which is in a file beside the recording by now. */
void publisher_put(struct publisher *p, int64_t time_ns, const void *input, const void *output,
                   const void *truth);

/* Whether the viewer was heard of within the last seconds, so that what it has set still
 * counts. */
bool publisher_is_heard(struct publisher *p, int64_t now_ns);

/* The run is over. */
void publisher_end(struct publisher *p);

#endif
