/* frob/trace.h -- a program's inputs and outputs as the columns and rows of a
 * CSV trace (quoting as in RFC 4180).
 *
 * The first column is `time`, in seconds with nine decimals. Then comes one
 * column for each scalar, sum or event, named by its path: `in`, `in.1`,
 * `in.odometry.position.x`, `in.sonar[0]`, `out.turn`. A `()` has no column.
 * A program with probes has a column for each after its output's, `probe.NAME`.
 * Last, if asked for, comes one for each machine, `mode.NAME`, with the name of
 * the mode that runs after the instant; it is empty while the machine is not
 * there, being part of a mode of another that does not run. */
#ifndef FROB_TRACE_H
#define FROB_TRACE_H

#include <frob/program.h>
#include <frob/text.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Called for each column of a value, in order. `name` is good for the call. */
typedef void frob_column_visitor(void *context, const char *name, const struct frob_value *value);

/* Visits the columns of a program's input or output; `root` is their first
 * word, `in` or `out`. */
void frob_trace_columns(const struct frob_value *value, const char *root,
                        frob_column_visitor *visit, void *context);

/* What a trace's rows hold besides the time. */
enum frob_trace_parts { FROB_TRACE_IN = 1, FROB_TRACE_OUT = 2, FROB_TRACE_MODES = 4 };

/* Appends the header line, with its line feed. */
void frob_trace_header(struct frob_text *text, const struct frob_program *program, unsigned parts);

/* Appends one row, with its line feed. `time_ns` counts from the first
 * instant's time stamp of choice; in and out may be NULL if not in `parts`.
 * Without modes: see frob_trace_row_with_modes. */
void frob_trace_row(struct frob_text *text, const struct frob_program *program, unsigned parts,
                    int64_t time_ns, const void *in, const void *out);

/* Likewise, and the modes too, from the program's state. */
void frob_trace_row_with_modes(struct frob_text *text, const struct frob_program *program,
                               unsigned parts, int64_t time_ns, const void *in, const void *out,
                               const void *state);

/* The number of the mode of machine `i` that runs, from the program's state; -1
 * while the machine is not there. */
int32_t frob_trace_mode(const struct frob_program *program, size_t i, const void *state);

/* Room that is enough for the header and for any row, with the NUL. */
size_t frob_trace_room(const struct frob_program *program, unsigned parts);

#ifdef __cplusplus
}
#endif
#endif
