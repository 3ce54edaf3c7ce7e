/* replay.h -- runs the program again on the inputs of a recording, so that all its signals are
 * available at any instant. */
#ifndef FROB_VIEW_REPLAY_H
#define FROB_VIEW_REPLAY_H

#include "../../common/params.h"
#include "display.h"
#include "recording.h"
#include "watch.h"

/* The interval, in instants, at which the state is stored. Any instant can be reached from a stored
 * state in fewer steps than this. */
#define REPLAY_EVERY 64

struct replay {
    struct recording *recording; /* the recording, whose frames are checked before the program uses
                                  * them */
    const struct signals *signals;
    const struct signal **compared; /* the recorded outputs, `compared_count` of them */
    size_t compared_count;
    struct params params; /* the parameters: values that were recorded or set, or the defaults */
    bool runs;            /* whether the recording contains everything that the program needs */
    unsigned char *kept;  /* states before the instants 0, REPLAY_EVERY, … */
    size_t room;          /* number of states that `kept` has room for */
    /* Number of instants that have been run: states have been stored for them, and their outputs
     * compared with the recorded ones. */
    size_t reached;
    unsigned char *state, *output; /* the state after instant `next - 1` */
    size_t next;
    bool diverged;      /* whether an output differs from the recorded one */
    size_t diverged_at; /* the first instant at which it differs */
    const struct signal *diverged_in;
    struct display display; /* display after instant `next - 1` */
    struct shown *shown;    /* displays at the stored states */
    struct watch watch;     /* assertion results before instant `reached` */
};

/* Prepares a replay without running any instant. The program that `signals` belongs to may differ
 * from the one for which the recording was read, but must have the same input and output. Sets the
 * parameters in `settings` (see recording.h). Returns false if memory runs out. */
bool replay_start(struct replay *replay, const struct signals *signals, struct recording *recording,
                  const struct buffer *settings);
void replay_end(struct replay *replay);

/* Returns whether the program has been run as far as possible: over the whole recording, or up to
 * the first instant that cannot be run. */
bool replay_is_whole(const struct replay *replay);

/* Runs at most REPLAY_EVERY more instants. The recording may have grown. */
void replay_advance(struct replay *replay);

/* Returns instant `k` of the recording, which is valid until the next call. Runs the program as
 * far as necessary. If it cannot be run that far, the output is the recorded one, and `state` is
 * NULL. */
struct moment replay_at(struct replay *replay, size_t k);

/* Returns the display at instant `k`. Sets *marks to the output that contains the display's marks,
 * or to NULL if it has none; the output is valid until the next call. */
struct shown replay_shown(struct replay *replay, size_t k, const void **marks);

#endif
