/* frob/trace.h -- writes a program's inputs and outputs as the columns and rows of a CSV trace
 * (quoted as in RFC 4180).
 *
 * The first column is `time`, in seconds with nine decimals. It is followed by one column for each
 * scalar, sum or event, named by its path: `in`, `in.1`, `in.odometry.position.x`, `in.sonar[0]`,
 * `out.turn`. A `()` has no column. If the program has probes, their columns, `probe.NAME`, follow
 * those of the output. The last columns, which are optional, are `mode.NAME` for each machine, with
 * the name of the mode that runs after the instant. The cell is empty while the machine does not
 * exist: a machine inside another machine's mode exists only while that mode runs. */
#ifndef FROB_TRACE_H
#define FROB_TRACE_H

#include <frob/program.h>
#include <frob/text.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Called for each column of a value, in order. `name` is valid during the call. */
typedef void frob_column_visitor(void *context, const char *name, const struct frob_value *value);

/* Visits the columns of a program's input or output. `root` is the first component of their names,
 * `in` or `out`. */
void frob_trace_columns(const struct frob_value *value, const char *root,
                        frob_column_visitor *visit, void *context);

/* The contents of a trace's rows, in addition to the time. */
enum frob_trace_parts { FROB_TRACE_IN = 1, FROB_TRACE_OUT = 2, FROB_TRACE_MODES = 4 };

/* Appends the header line, with its line feed. */
void frob_trace_header(struct frob_text *text, const struct frob_program *program, unsigned parts);

/* Appends one row, with its line feed. `time_ns` is relative to an instant that the caller chooses.
 * `in` and `out` may be NULL if they are not in `parts`. Does not write modes; use
 * frob_trace_row_with_modes for that. */
void frob_trace_row(struct frob_text *text, const struct frob_program *program, unsigned parts,
                    int64_t time_ns, const void *in, const void *out);

/* Appends one row in the same way, followed by the modes, which it reads from the program's
 * state. */
void frob_trace_row_with_modes(struct frob_text *text, const struct frob_program *program,
                               unsigned parts, int64_t time_ns, const void *in, const void *out,
                               const void *state);

/* Reads the number of the running mode of machine `i` from the program's state; returns -1 while
 * the machine does not exist. */
int32_t frob_trace_mode(const struct frob_program *program, size_t i, const void *state);

/* Returns the size of a buffer that is large enough for the header and for any row, with the
 * NUL. */
size_t frob_trace_room(const struct frob_program *program, unsigned parts);

#ifdef __cplusplus
}
#endif
#endif
