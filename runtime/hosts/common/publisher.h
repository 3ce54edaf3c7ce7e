/* publisher.h -- publishes a run in shared memory for a viewer, which is a separate process.
 *
 * The run does not depend on the viewer, which may be slow, stop reading, or end at any time. */
#ifndef FROB_HOST_PUBLISHER_H
#define FROB_HOST_PUBLISHER_H

#include "ring.h"

#include <frob/program.h>

#include <sys/types.h>

struct publisher {
    pid_t viewer;     /* 0: none */
    struct ring ring; /* a ring without memory if there is no viewer */
    const struct frob_program *program;
    unsigned char *input; /* copy of the input for the viewer, with keys instead of images;
                           * NULL if the program has no images */
    uint32_t beats;       /* the viewer's heartbeat when it was last read */
    int64_t heard_ns;     /* time at which the heartbeat was last seen to change */
};

/* Starts the viewer with `--ring NUMBER` before its other arguments. `viewer`: the NULL-terminated
 * command; NULL: no viewer. `truth_size`, `permissions`: see ring.h. If the viewer cannot be
 * started, prints a warning, and the run continues without it. */
void publisher_start(struct publisher *p, const struct frob_program *program, size_t truth_size,
                     unsigned permissions, char *const *viewer);

/* Publishes the next instant. In the published data, the key of the frame (frames.h) replaces the
 * address of an image. The frame must already be in a file next to the recording. */
void publisher_put(struct publisher *p, int64_t time_ns, const void *input, const void *output,
                   const void *truth);

/* Returns whether the viewer sent a heartbeat within the last two seconds, so that its settings
 * still apply. */
bool publisher_is_heard(struct publisher *p, int64_t now_ns);

/* Reports that the run is over, and whether the robot is known to be at rest. */
void publisher_end(struct publisher *p, enum ring_fate fate);

/* Ends the viewer, so that no process is left running. If `is_wanted`, first waits while a page is
 * open; SIGINT, SIGTERM or SIGHUP ends the wait, and so does a viewer that hangs. Call it after
 * publisher_end, when the run's results have been written and the robot's line has been closed. */
void publisher_leave(struct publisher *p, bool is_wanted);

#endif
