/* bench.h -- replaces the file of this name in `step/`: measures the generated step alone, on a
 * Cortex-M4 that qemu emulates with `-icount shift=0`, where each instruction takes 1 ns. Prints
 * the average number of instructions of a step, including its call.
 *
 * With BENCH_SINGLE the program uses single precision. */
#ifndef FROB_BENCH_CORTEX_M_H
#define FROB_BENCH_CORTEX_M_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

enum { INSTANTS = 1024 };

/* The same numbers as in `step/bench.c`. */
static inline double bench_random(void)
{
    static uint64_t state = UINT64_C(0x9e3779b97f4a7c15);
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (double)(state >> 11) / 9007199254740992.0;
}

static inline int bench_chance(double probability)
{
    return bench_random() < probability;
}

/* The processor's timer, SysTick, counts down from 2^24 at the board's 25 MHz. */
#define SYSTICK ((volatile uint32_t *)0xE000E010u)
enum { CONTROL, RELOAD, VALUE, TICK_NS = 40, MOST_TICKS = 0xFFFFFF };

static void ticks_start(void)
{
    SYSTICK[RELOAD] = MOST_TICKS;
    SYSTICK[VALUE] = 0;
    SYSTICK[CONTROL] = 5; /* run from the processor's clock, without interrupts */
}

static uint32_t ticks_passed(void)
{
    return MOST_TICKS - SYSTICK[VALUE];
}

#ifdef BENCH_SINGLE
typedef float bench_real;
#else
typedef double bench_real;
#endif

#define BENCH(program)                                                      \
    static struct program##_input input[INSTANTS];                          \
    static int64_t dt_ns[INSTANTS];                                         \
    static bench_real dt[INSTANTS];                                         \
    static void make_input(size_t i);                                       \
    int main(void)                                                          \
    {                                                                       \
        static struct program##_state state;                                \
        static struct program##_output output;                              \
        for (size_t i = 0; i < INSTANTS; i++) {                             \
            dt_ns[i] = i == 0 ? 0 : (int64_t)(19e6 + 2e6 * bench_random()); \
            dt[i] = (bench_real)dt_ns[i] / (bench_real)1e9;                 \
            make_input(i);                                                  \
        }                                                                   \
        program##_reset(&state);                                            \
        ticks_start();                                                      \
        for (size_t i = 0; i < INSTANTS; i++)                               \
            program##_step_ns(&state, dt_ns[i], dt[i], &input[i], &output); \
        printf("%.1f\n", (double)ticks_passed() * TICK_NS / INSTANTS);      \
        return 0;                                                           \
    }

#endif
