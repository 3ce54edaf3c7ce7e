/* Recordings of a program's input, and what it must answer to each. */
#ifndef EXPECTED_H
#define EXPECTED_H

#include <stdint.h>

struct row {
    int64_t time_ns;
    const char *const *cells; /* of the input's columns, in their order */
};

struct recording {
    const struct row *rows;
    int count;
    uint64_t trace; /* FNV-1a of the trace of the output */
};

extern const struct recording recordings[];
extern const int recording_count;

#endif
