/* Recordings of a program's input, and the expected results for each. */
#ifndef EXPECTED_H
#define EXPECTED_H

#include <stdint.h>

struct row {
    int64_t time_ns;
    uint64_t dt;              /* the step's dt in seconds: the bits of a double */
    const char *const *cells; /* cells of the input's columns, in order */
};

struct recording {
    const struct row *rows;
    int count;
    const char *const *params; /* cells of the program's parameters, in order */
    uint64_t trace;            /* FNV-1a hash of the output's trace */
    /* NAME_step of a single-precision program, if this test passes each dt to it as a float;
     * otherwise NULL, and the test calls the step in the table for hosts, which takes a double. */
    void (*step_single)(void *state, const void *params, float dt, const void *input, void *output);
};

extern const struct recording recordings[];
extern const int recording_count;

/* Mixes the program's state into the hash, field by field in the struct's order. Leaves out
 * padding and the states of modes that are not running. */
void hash_state(uint64_t *hash, const void *state);

/* Mixes in one number. All NaNs count as the same. */
void mix_int(uint64_t *hash, int64_t number);
void mix_real(uint64_t *hash, double number);

#endif
