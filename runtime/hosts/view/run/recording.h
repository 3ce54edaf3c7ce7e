/* recording.h -- a recorded run, read into memory: for each instant its time, the
 * program's input, and the output as it was recorded. */
#ifndef FROB_VIEW_RECORDING_H
#define FROB_VIEW_RECORDING_H

#include "../buffer.h"
#include "signals.h"

#include "../../common/frames.h"

struct recording {
    const struct frob_program *program;
    const char *name;
    size_t count;               /* of instants */
    int64_t *times;             /* in nanoseconds */
    unsigned char *inputs;      /* count times the program's input struct */
    unsigned char *outputs;     /* count times the part of the output struct that a recording
                             * has; a signal that was not recorded is zero */
    size_t output_size;         /* of that part: inner signals are after it */
    bool *recorded;             /* for each signal: is there a column of it? */
    struct buffer params;       /* how parameters were set, NAME=VALUE each, with a NUL */
    bool has_all_inputs;        /* so that the program can be run on it */
    struct frame_reader frames; /* beside it: what inputs point to stays while it does */
    struct buffer notes;        /* what was wrong, a line each: what is shown is all the rest */
    size_t capacity;
    size_t gap; /* before this instant some were missed, of a run that goes on, or
                             * here a frame is: the program cannot be run further; or NO_GAP */
    const struct frob_value **eyes; /* the events of frames in the program's input */
    size_t eye_count;
    struct lost_frame *lost; /* of a frame that is not there the event does not occur */
    size_t lost_count;
    size_t checked;        /* frames of the instants before this one are those recorded */
    unsigned char *truths; /* count times what a simulator knows, or NULL … */
    size_t truth_size;     /* … of so many bytes */
    struct reader *reader; /* of a file of which there is more; NULL: it has been read */
};

#define NO_GAP SIZE_MAX

/* A frame that the recording names, and whose file is missing, or is not what it was. */
struct lost_frame {
    size_t k;
    uint32_t number;
    bool is_there; /* but changed */
};

/* Begins to read a file, as far as its first rows, which is all of most. What does not fit the
 * program is left out, with a line in `notes`: columns that it does not have, and all from the
 * first row that cannot be read. False, with one line on standard error, if nothing is left. */
bool recording_read(struct recording *recording, const struct signals *signals, const char *name);

/* Reads some more rows. False if that was all. */
bool recording_read_on(struct recording *recording);

/* Sets parameters to other values than those recorded, if any, NAME=VALUE each; what is wrong
 * with those recorded, or other than these, is noted. False, with one line on standard error,
 * if these are wrong. */
bool recording_set(struct recording *recording, const char *const *params, size_t count);

/* A recording of a run that goes on, which grows. `name` is that of the run. False without
 * memory, with a line on standard error. */
bool recording_begin(struct recording *recording, const struct signals *signals, const char *name,
                     size_t truth_size);

/* Adds an instant. `output` begins as the program's output struct does, in `output_size`
 * bytes. False without memory. */
bool recording_add(struct recording *recording, int64_t time_ns, const void *input,
                   const void *output, size_t output_size, const void *truth);

/* A file that a run is being recorded in, from which what was missed can be added. */
struct catching;

/* Opens it, at its first row. NULL if it is not such a file, or is compressed: of that the last
 * rows are in no file yet. */
struct catching *catching_start(const struct signals *signals, const char *name);

/* Adds the rows from instant `count` to before instant `end`, which have been written. False
 * if they are not all there; some of them may have been added. */
bool catching_take(struct catching *catching, struct recording *recording, size_t end);

void catching_end(struct catching *catching);

void recording_free(struct recording *recording);

/* Seconds from instant `k - 1` to `k`, as the program is told: 0 at the first. */
double recording_dt(const struct recording *recording, size_t k);

const void *recording_input(const struct recording *recording, size_t k);
const void *recording_output(const struct recording *recording, size_t k);
const void *recording_truth(const struct recording *recording, size_t k);

#endif
