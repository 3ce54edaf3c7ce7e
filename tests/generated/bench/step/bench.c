#define _POSIX_C_SOURCE 199309L
#include "bench.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { MOST_ROUNDS = 1001 };

int64_t bench_dt_ns[INSTANTS];
double bench_dt[INSTANTS];

/* True while the inputs contain extreme values. */
static bool has_extremes;

double bench_random(void)
{
    static uint64_t state = UINT64_C(0x9e3779b97f4a7c15);
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    if (has_extremes && state % 64 == 0)
        return state % 512 == 0 ? (double)NAN : -10.0;
    return (double)(state >> 11) / 9007199254740992.0;
}

int bench_chance(double probability)
{
    return bench_random() < probability;
}

static double now_ns(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

static double step_time(void (*pass)(void))
{
    const double start = now_ns();
    pass();
    return (now_ns() - start) / INSTANTS;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *values, int count)
{
    qsort(values, (size_t)count, sizeof *values, ascending);
    return values[count / 2];
}

/* Whether the outputs are equal: bit for bit, both zero, or both NaN. */
static bool equal(const struct bench *bench)
{
    for (size_t i = 0; i < bench->doubles; i++) {
        const double x = bench->generated_outputs[i], y = bench->by_hand_outputs[i];
        if (memcmp(&x, &y, sizeof x) != 0 && x != y && !(isnan(x) && isnan(y))) {
            const size_t outputs = bench->doubles / INSTANTS;
            fprintf(stderr, "instant %lu, output %lu: generated %.17g, by hand %.17g\n",
                    (unsigned long)(i / outputs), (unsigned long)(i % outputs), x, y);
            return false;
        }
    }
    return true;
}

/* Generates the times and inputs. With extremes, no time passes in some instants, and some inputs
 * are negative or NaN. */
static void make_inputs(const struct bench *bench, bool extremes)
{
    for (size_t i = 0; i < INSTANTS; i++) {
        const bool passes = i > 0 && !(extremes && i % 16 == 0);
        bench_dt_ns[i] = passes ? (int64_t)(19e6 + 2e6 * bench_random()) : 0;
        bench_dt[i] = (double)bench_dt_ns[i] / 1e9;
    }
    has_extremes = extremes;
    bench->make_inputs();
}

int bench_main(const struct bench *bench, int argc, char **argv)
{
    static double generated[MOST_ROUNDS], by_hand[MOST_ROUNDS];
    const int rounds = argc == 2 ? atoi(argv[1]) : -1;
    if (rounds < 0 || rounds > MOST_ROUNDS) {
        fprintf(stderr, "usage: %s ROUNDS\n", argv[0]);
        return 2;
    }
    make_inputs(bench, rounds == 0);
    if (rounds == 0) {
        bench->generated_pass();
        bench->by_hand_pass();
        return equal(bench) ? 0 : 1;
    }
    for (int round = 0; round < rounds; round++) {
        /* alternate which step goes first */
        if (round % 2 == 0)
            generated[round] = step_time(bench->generated_pass);
        by_hand[round] = step_time(bench->by_hand_pass);
        if (round % 2 != 0)
            generated[round] = step_time(bench->generated_pass);
        /* some tools' programs cannot be restarted, so later rounds may differ */
        if (round == 0 && !equal(bench))
            return 1;
    }
    printf("%.4g %.4g %lu %lu\n", median(generated, rounds), median(by_hand, rounds),
           (unsigned long)bench->generated_bytes, (unsigned long)bench->by_hand_bytes);
    return 0;
}
