/* live.h -- a live run: adds the instants that its host publishes to a recording. */
#ifndef FROB_VIEW_LIVE_H
#define FROB_VIEW_LIVE_H

#include "recording.h"

#include "../../common/ring.h"

struct live {
    struct ring *ring;         /* NULL for the recording of a run that is over */
    const char *file;          /* file in which the host records the run; NULL if there is none */
    struct catching *catching; /* reads missed instants from `file`; NULL until it is needed */
    const struct signals *signals;
    struct recording *recording;
    unsigned char *input, *output, *truth; /* buffers for one instant */
    bool full;                             /* whether memory has run out */
    long host;                             /* process id of the host, the parent process */
    uint64_t left;                         /* index of the next instant of the run to add */
    bool is_behind;                        /* whether the host is known to have published more
                                            * instants */
    bool has_ended;                        /* whether the run is over and all of it has been
                                            * added */
};

/* Prepares for a live run without reading any instants. The program that `signals` describes must
 * be the one that the host runs, but may have additional probes. On failure, prints a line on
 * standard error and returns false. */
bool live_start(struct live *live, struct ring *ring, const char *file,
                const struct signals *signals, struct recording *recording);
void live_end(struct live *live);

/* Adds at most `most` published instants. Instants that the host has overwritten are read from the
 * file in which it records. If there is no such file, the recording has a gap (see recording.h)
 * and a note. Returns false if there was nothing new. */
bool live_take(struct live *live, size_t most);

#endif
