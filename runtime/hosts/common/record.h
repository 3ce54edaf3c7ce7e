/* record.h -- writes a run as a CSV trace, with inputs and outputs.
 *
 * Each row goes to the file as a whole, at once: a host that is killed loses
 * no row that was complete, nor does one whose recording is compressed (packed.h). Frames of cameras are written before the row that names them
 * (frames.h). */
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
    struct packer file; /* none: nothing is recorded */
    char *buffer;
    struct frob_text text;
    struct frame_writer frames;
};

/* Opens the file and writes the values of the parameters, if the program has any, and the
 * header; without a name nothing is recorded.
 * The functions return false when it cannot be written, with a line on
 * standard error. */
bool record_open(struct record *r, const struct frob_program *program, const void *params,
                 const char *name);
bool record_row(struct record *r, int64_t time_ns, void *in, const void *out);
bool record_close(struct record *r);

#endif
