/* bench.h -- compares one program's generated step with the same step written by hand, in one
 * process.
 *
 * A program's bench.c contains BENCH(name) and defines make_input. Both steps get the same table
 * of inputs and store all outputs in tables, which must be equal at the end. The hand-written
 * step takes the generated structs of input and output, so that it could replace the generated
 * one.
 *
 * The steps are those for hosts, which get the time in nanoseconds and in seconds. With
 * BENCH_IN_SECONDS, both steps round seconds instead. With BENCH_BATCH, the generated step is
 * compared with itself: all instants in one call (`frobc compile --batch`), and one call for each
 * instant. */
#ifndef FROB_BENCH_H
#define FROB_BENCH_H

#include <stddef.h>
#include <stdint.h>

/* Large enough that the processor cannot learn the table's branches. */
enum { INSTANTS = 16384 };

/* The time since the previous instant, around 20 ms, in whole nanoseconds and in seconds; 0 in the
 * first instant. */
extern int64_t bench_dt_ns[INSTANTS];
extern double bench_dt[INSTANTS];

/* Uniform random numbers in [0, 1) from xorshift instead of rand(), so that they are the same on
 * every machine. */
double bench_random(void);

/* True with this probability. */
int bench_chance(double probability);

/* The definitions of one program. A pass runs all instants after a reset. The outputs are
 * structs of doubles, `doubles` in total. */
struct bench {
    void (*make_inputs)(void);
    void (*generated_pass)(void);
    void (*by_hand_pass)(void);
    const double *generated_outputs;
    const double *by_hand_outputs;
    size_t doubles;
    size_t generated_bytes; /* size of the state */
    size_t by_hand_bytes;
};

/* Runs the rounds, compares the outputs and prints
 *     STEP_NS STEP_NS_BY_HAND STATE_BYTES STATE_BYTES_BY_HAND
 * The only argument is the number of rounds; the times are medians. If it is 0, the program only
 * compares the outputs, for inputs that are sometimes NaN or out of range, and for instants in which
 * no time passes. */
int bench_main(const struct bench *bench, int argc, char **argv);

/* Never inlined, so that valgrind can count its instructions. */
#define BENCH_PASS __attribute__((noinline))

#ifdef BENCH_IN_SECONDS
#define BENCH_STEP(program, state, i, output) program##_step(state, bench_dt[i], &input[i], output)
#define BENCH_BY_HAND(state, i, output) \
    by_hand_step_in_seconds(state, bench_dt[i], &input[i], output)
#else
#define BENCH_STEP(program, state, i, output) \
    program##_step_ns(state, bench_dt_ns[i], bench_dt[i], &input[i], output)
#define BENCH_BY_HAND(state, i, output) \
    by_hand_step(state, bench_dt_ns[i], bench_dt[i], &input[i], output)
#endif

#ifdef BENCH_BATCH
#define BENCH_PASSES(program)                                                                 \
    static struct program##_state by_hand_state;                                              \
    static BENCH_PASS void generated_pass(void)                                               \
    {                                                                                         \
        program##_reset(&generated_state);                                                    \
        program##_steps(&generated_state, INSTANTS, bench_dt_ns, bench_dt, input, generated); \
    }                                                                                         \
    static BENCH_PASS void by_hand_pass(void)                                                 \
    {                                                                                         \
        program##_reset(&by_hand_state);                                                      \
        for (size_t i = 0; i < INSTANTS; i++)                                                 \
            BENCH_STEP(program, &by_hand_state, i, &by_hand[i]);                              \
    }
#else
#define BENCH_PASSES(program)                                        \
    static struct by_hand by_hand_state;                             \
    static BENCH_PASS void generated_pass(void)                      \
    {                                                                \
        program##_reset(&generated_state);                           \
        for (size_t i = 0; i < INSTANTS; i++)                        \
            BENCH_STEP(program, &generated_state, i, &generated[i]); \
    }                                                                \
    static BENCH_PASS void by_hand_pass(void)                        \
    {                                                                \
        by_hand_reset(&by_hand_state);                               \
        for (size_t i = 0; i < INSTANTS; i++)                        \
            BENCH_BY_HAND(&by_hand_state, i, &by_hand[i]);           \
    }
#endif

#define BENCH(program)                                                        \
    static struct program##_input input[INSTANTS];                            \
    static struct program##_output generated[INSTANTS], by_hand[INSTANTS];    \
    static struct program##_state generated_state;                            \
    static void make_input(size_t i);                                         \
    static void make_inputs(void)                                             \
    {                                                                         \
        for (size_t i = 0; i < INSTANTS; i++)                                 \
            make_input(i);                                                    \
    }                                                                         \
    BENCH_PASSES(program)                                                     \
    int main(int argc, char **argv)                                           \
    {                                                                         \
        const struct bench bench = { make_inputs,                             \
                                     generated_pass,                          \
                                     by_hand_pass,                            \
                                     (const double *)(const void *)generated, \
                                     (const double *)(const void *)by_hand,   \
                                     sizeof generated / (sizeof(double)),     \
                                     sizeof generated_state,                  \
                                     sizeof by_hand_state };                  \
        return bench_main(&bench, argc, argv);                                \
    }

#endif
