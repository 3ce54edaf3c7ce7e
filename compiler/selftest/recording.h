/* recording.h -- a program's input, as the cells of a trace, and its expected output.
 * `frobc selftest` writes both as C code, so that the test does not need any files. */
#ifndef FROB_SELFTEST_RECORDING_H
#define FROB_SELFTEST_RECORDING_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

struct recorded_row {
    int64_t time_ns;
    const char *const *cells; /* input cells, in the order of the columns */
    const char *output;       /* the expected row of the trace, with its line feed */
};

extern const struct recorded_row recorded_rows[];
extern const int recorded_row_count;

#ifdef __cplusplus
}
#endif
#endif
