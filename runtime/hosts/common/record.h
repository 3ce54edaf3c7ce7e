/* record.h -- records a run as a CSV trace, with inputs and outputs.
 *
 * Each row is written to the file immediately and as a whole, so no complete row is lost if the
 * host is killed, even if the recording is compressed (packed.h). Camera frames are written before
 * the row that names them (frames.h). */
#ifndef FROB_HOST_RECORD_H
#define FROB_HOST_RECORD_H

#include "frames.h"
#include "packed.h"

#include <frob/trace.h>

#include <stdbool.h>
#include <stdint.h>

struct record {
    const struct frob_program *program;
    const char *name;
    struct packer file; /* empty if nothing is recorded */
    char *buffer;
    struct frob_text text;
    struct frame_writer frames;
};

/* Opens the file, and writes the values of the parameters, if the program has any, and the header.
 * If `name` is NULL, nothing is recorded. These functions print a line on standard error and return
 * false if the file cannot be written. */
bool record_open(struct record *r, const struct frob_program *program, const void *params,
                 const char *name);
bool record_row(struct record *r, int64_t time_ns, void *in, const void *out);
bool record_close(struct record *r);

/* Reports that the user interrupted the run at `time_s`, what was saved, and how to start over.
 * `name` is the name of the recording, or NULL. */
void record_report_interruption(const char *name, double time_s);

#endif
