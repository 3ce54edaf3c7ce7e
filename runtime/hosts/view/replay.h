/* replay.h -- the program run again on the inputs of a recording, so that all of it
 * can be seen at any instant. */
#ifndef FROB_VIEW_REPLAY_H
#define FROB_VIEW_REPLAY_H

#include "recording.h"

/* Of how many instants one has its state kept, so that the program can be set to any
 * instant in fewer steps. */
#define REPLAY_EVERY 64

struct replay {
    const struct recording *recording;
    const struct signals *signals;
    bool runs;                    /* the recording has all that the program needs */
    unsigned char *kept;          /* the states before instants 0, REPLAY_EVERY, … */
    unsigned char *state, *output; /* after instant `next - 1` */
    size_t next;
    bool diverged;                /* an output is not the recorded one … */
    size_t diverged_at;           /* … first at this instant */
    const struct signal *diverged_in;
};

/* Runs the program over the whole recording, and compares its outputs with those
 * recorded. False without memory. */
bool replay_start(struct replay *replay, const struct signals *signals,
                  const struct recording *recording);
void replay_end(struct replay *replay);

/* Instant `k` of the recording; good until the next call. If the program cannot be
 * run, outputs are those recorded, and `state` is NULL. */
struct moment replay_at(struct replay *replay, size_t k);

#endif
