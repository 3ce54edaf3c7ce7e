/* Recordings of a program's input, and what it must answer to each. */
#ifndef EXPECTED_H
#define EXPECTED_H

#include <stdint.h>

struct row {
    int64_t time_ns;
    uint64_t dt;              /* what the step is given, in seconds: the bits of a double */
    const char *const *cells; /* of the input's columns, in their order */
};

struct recording {
    const struct row *rows;
    int count;
    const char *const *params; /* cells of the program's parameters, in their order */
    uint64_t trace;            /* FNV-1a of the trace of the output */
    /* NAME_step of a program in single precision, if that is given each dt as a float
     * here; or NULL, and the step of the table for hosts gets a double. */
    void (*step_single)(void *state, const void *params, float dt, const void *input, void *output);
};

extern const struct recording recordings[];
extern const int recording_count;

/* Mixes the program's state into the hash, field by field in the struct's order,
 * without padding and what no mode that runs holds. */
void hash_state(uint64_t *hash, const void *state);

/* Of one number: all NaNs are one. */
void mix_int(uint64_t *hash, int64_t number);
void mix_real(uint64_t *hash, double number);

#endif
