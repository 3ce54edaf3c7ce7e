/* live.h -- a run that goes on: what its host publishes becomes a recording. */
#ifndef FROB_VIEW_LIVE_H
#define FROB_VIEW_LIVE_H

#include "recording.h"

#include "../../common/ring.h"

struct live {
    struct ring *ring;         /* NULL: this is a recording of a run that is over */
    const char *file;          /* that the host records in; NULL: none */
    struct catching *catching; /* up with it; NULL: there was no need yet */
    const struct signals *signals;
    struct recording *recording;
    unsigned char *input, *output, *truth; /* of an instant */
    bool full;                             /* there is no memory for more */
    long host;                             /* the process, which is the parent of this one */
    uint64_t left;  /* before this instant of the run all are there, or never will be */
    bool has_ended; /* the run, and all of it was taken */
};

/* Takes nothing yet. The program of the signals is to be that of the host, perhaps with probes.
 * False with a line on standard error. */
bool live_start(struct live *live, struct ring *ring, const char *file,
                const struct signals *signals, struct recording *recording);
void live_end(struct live *live);

/* Takes what was published, at most `most` instants. What the host has overwritten meanwhile is
 * taken from the file it records in; without one the recording has a gap from there on (see
 * recording.h), and a note. False if there was nothing new. */
bool live_take(struct live *live, size_t most);

#endif
