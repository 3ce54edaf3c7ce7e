/* recording.h -- a program's input, as the cells of a trace, and what its output
 * must be. `frobc selftest` writes it as C, so that the test needs no files. */
#ifndef FROB_SELFTEST_RECORDING_H
#define FROB_SELFTEST_RECORDING_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

struct recorded_row {
    int64_t time_ns;
    const char *const *cells; /* of the input, in the order of its columns */
    const char *output;       /* the row of the trace, with its line feed */
};

extern const struct recorded_row recorded_rows[];
extern const int recorded_row_count;

#ifdef __cplusplus
}
#endif
#endif
