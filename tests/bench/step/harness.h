/* harness.h -- step times of generated C beside hand-written C, in one
 * process.
 *
 * They take turns on the same inputs, a table of instants, and store all
 * outputs in tables, which must be equal in the end. A round is one pass over
 * the table; the figure is the median of the rounds, in nanoseconds a step.
 * The table is so long that a processor does not learn its branches by heart.
 *
 * Generated code rounds dt to whole nanoseconds, as the language promises.
 * So does the hand-written code that it is compared with; a second comparison
 * is with the same code that takes dt as it comes. */
#ifndef FROB_BENCH_HARNESS_H
#define FROB_BENCH_HARNESS_H

#include <stddef.h>

enum { INSTANTS = 16384, ROUNDS = 201 };

/* The same numbers on every machine: xorshift, not rand(). Uniform in [0, 1). */
double bench_random(void);

/* One pass over all instants. */
typedef void bench_pass(void);

struct bench_row {
    const char *program;
    bench_pass *generated;
    bench_pass *by_hand;
    bench_pass *by_hand_as_it_comes;
    size_t generated_bytes;
    size_t by_hand_bytes;
};

/* Times them by turns, and prints one JSON object a line: the two step times
 * and the bytes of state. */
void bench_compare(const struct bench_row *row);

/* Ends the process with a message if two outputs differ. */
void bench_equal(const char *program, size_t instant, double generated, double by_hand);

#endif
