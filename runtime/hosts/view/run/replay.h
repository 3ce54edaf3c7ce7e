/* replay.h -- the program run again on the inputs of a recording, so that all of it
 * can be seen at any instant. */
#ifndef FROB_VIEW_REPLAY_H
#define FROB_VIEW_REPLAY_H

#include "../../common/params.h"
#include "display.h"
#include "recording.h"
#include "watch.h"

/* Of how many instants one has its state kept, so that the program can be set to any
 * instant in fewer steps. */
#define REPLAY_EVERY 64

struct replay {
    struct recording *recording; /* its frames are looked at before the program sees them */
    const struct signals *signals;
    struct params params;          /* as they were set, or else by default */
    bool runs;                     /* the recording has all that the program needs */
    unsigned char *kept;           /* the states before instants 0, REPLAY_EVERY, …, … */
    size_t room;                   /* … of so many of which there is room */
    size_t reached;                /* before this instant all states are kept, and outputs
                                    * compared with those recorded */
    unsigned char *state, *output; /* after instant `next - 1` */
    size_t next;
    bool diverged;      /* an output is not the recorded one … */
    size_t diverged_at; /* … first at this instant */
    const struct signal *diverged_in;
    struct display display; /* after instant `next - 1` … */
    struct shown *shown;    /* … and before the instants whose states are kept */
    struct watch watch;     /* before instant `reached` */
};

/* Nothing is run yet. The program of the signals need not be the one that the recording was
 * read for, but must have the same input and output. Of its parameters those are set that
 * `settings` has (see recording.h). False without memory. */
bool replay_start(struct replay *replay, const struct signals *signals, struct recording *recording,
                  const struct buffer *settings);
void replay_end(struct replay *replay);

/* Has the whole recording been run over, up to where it has a gap? */
bool replay_is_whole(const struct replay *replay);

/* Runs on for at most REPLAY_EVERY instants. The recording may have grown. */
void replay_advance(struct replay *replay);

/* Instant `k` of the recording; good until the next call. If the program cannot be
 * run, or not so far, outputs are those recorded, and `state` is NULL. Runs on as far as is
 * needed. */
struct moment replay_at(struct replay *replay, size_t k);

/* What is shown of images at instant `k`, and the output that has the marks on it, if there are
 * any, or else NULL; good until the next call. */
struct shown replay_shown(struct replay *replay, size_t k, const void **marks);

#endif
