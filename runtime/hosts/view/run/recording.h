/* recording.h -- a recorded run in memory: the time, the program's input and the recorded output of
 * each instant. */
#ifndef FROB_VIEW_RECORDING_H
#define FROB_VIEW_RECORDING_H

#include "../buffer.h"
#include "signals.h"

#include "../../common/csv.h"
#include "../../common/frames.h"

struct recording {
    const struct frob_program *program;
    const char *name;
    size_t count;          /* number of instants */
    int64_t *times;        /* nanoseconds, relative to the origin */
    int64_t origin;        /* the first time, if the clock started long before the run; otherwise
                            * 0 */
    unsigned char *inputs; /* `count` input structs of the program */
    /* The recorded part of `count` output structs. Signals that were not recorded are zero. */
    unsigned char *outputs;
    size_t output_size;   /* size in bytes of the recorded part; inner signals follow it in the
                           * struct */
    bool *recorded;       /* for each signal: whether the recording has its column */
    struct buffer params; /* recorded parameters: NAME=VALUE, each ending with a NUL */
    bool has_all_inputs;  /* whether the program can be run on the recording */
    /* Reads the frames stored next to the recording. The images that inputs point to stay valid as
     * long as this reader exists. */
    struct frame_reader frames;
    struct buffer notes; /* lines about problems and parts that were ignored */
    size_t capacity;
    /* The first instant for which the program cannot be run, because it follows missed instants of
     * a live run or because its frame is missing. NO_GAP if there is no such instant. */
    size_t gap;
    const struct frob_value **eyes; /* the events in the program's input that contain frames */
    size_t eye_count;
    struct lost_frame *lost; /* missing or changed frames, whose events are removed from the
                              * input */
    size_t lost_count;
    size_t checked; /* the frames of the instants before this one have been checked */
    /* The simulator's ground truth: `count` structs of `truth_size` bytes each; NULL if there is
     * none. */
    unsigned char *truths;
    size_t truth_size;
    struct reader *reader; /* reads the rest of the file; NULL if there is none */
};

#define NO_GAP SIZE_MAX

/* A frame named in the recording whose file is missing or has changed. */
struct lost_frame {
    size_t k;
    uint32_t number;
    bool is_there; /* whether the file exists but has changed */
};

/* Opens a file and reads its first rows, which are usually all of its rows. Ignores columns that
 * the program does not have. Stops at the first row that cannot be read, and ignores the rest. Adds
 * a line about each problem to `notes`. If nothing is left, prints a line on standard error and
 * returns false. */
bool recording_read(struct recording *recording, const struct signals *signals, const char *name,
                    const struct csv_dialect *dialect);

/* Reads more rows. Returns false if there are no more. */
bool recording_read_on(struct recording *recording);

/* Sets parameters, each given as NAME=VALUE, in place of the recorded values. Adds notes about
 * recorded values that are invalid or differ from these settings. If a setting is invalid, prints a
 * line on standard error and returns false. */
bool recording_set(struct recording *recording, const char *const *params, size_t count);

/* Creates the growing recording of a live run. `name` is the name of the run. If memory runs out,
 * prints a line on standard error and returns false. */
bool recording_begin(struct recording *recording, const struct signals *signals, const char *name,
                     size_t truth_size);

/* Adds an instant. `output` contains the first `output_size` bytes of the program's output struct.
 * Returns false if memory runs out. */
bool recording_add(struct recording *recording, int64_t time_ns, const void *input,
                   const void *output, size_t output_size, const void *truth);

/* Reads missed instants from the file in which a run is being recorded. */
struct catching;

/* Opens the file at its first row. Returns NULL if it is not a recording, or if it is compressed,
 * because the last rows of a compressed file are not in the file yet. */
struct catching *catching_start(const struct signals *signals, const char *name);

/* Adds the rows from instant `count` up to, but not including, instant `end`. They must have been
 * written already. If some of them are missing, returns false, but may have added others. */
bool catching_take(struct catching *catching, struct recording *recording, size_t end);

void catching_end(struct catching *catching);

void recording_free(struct recording *recording);

/* Returns the dt that the program receives at instant `k`: the nanoseconds since instant `k - 1`,
 * or 0 at the first instant. */
int64_t recording_dt_ns(const struct recording *recording, size_t k);

const void *recording_input(const struct recording *recording, size_t k);
const void *recording_output(const struct recording *recording, size_t k);
const void *recording_truth(const struct recording *recording, size_t k);

#endif
