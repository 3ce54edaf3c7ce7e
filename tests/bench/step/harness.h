/* harness.h -- step times of generated C beside hand-written C, in one
 * process.
 *
 * The two take turns on the same inputs, a table of instants, and store all
 * outputs in tables, which must be equal in the end. A round is one pass over
 * the table; the figure is the median of the rounds, in nanoseconds a step. */
#ifndef FROB_BENCH_HARNESS_H
#define FROB_BENCH_HARNESS_H

#include <stddef.h>

enum { INSTANTS = 4096, ROUNDS = 601 };

/* The same numbers on every machine: xorshift, not rand(). Uniform in [0, 1). */
double bench_random(void);

/* One pass over all instants. */
typedef void bench_pass(void);

/* Times both by turns, and prints one JSON object a line for the step time
 * and one for the bytes of state. */
void bench_compare(const char *program, bench_pass *generated, bench_pass *by_hand,
                   size_t generated_bytes, size_t by_hand_bytes);

/* Ends the process with a message if two outputs differ. */
void bench_equal(const char *program, size_t instant, double generated, double by_hand);

#endif
