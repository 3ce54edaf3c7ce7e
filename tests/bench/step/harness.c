#define _POSIX_C_SOURCE 199309L
#include "harness.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

double bench_random(void)
{
    static uint64_t state = UINT64_C(0x9e3779b97f4a7c15);
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (double)(state >> 11) / 9007199254740992.0;
}

static double now_ns(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

static double time_of(bench_pass *pass)
{
    double start = now_ns();
    pass();
    return (now_ns() - start) / INSTANTS;
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *values, size_t count)
{
    qsort(values, count, sizeof *values, ascending);
    return values[count / 2];
}

#ifdef __clang__
static const char compiler[] = "clang";
#else
static const char compiler[] = "gcc";
#endif

static void print(const char *program, const char *measure, double value, double reference,
                  const char *unit)
{
    printf("{\"program\": \"%s\", \"measure\": \"%s\", \"compiler\": \"%s\", \"value\": %.4g, "
           "\"reference\": %.4g, \"ratio\": %.3f, \"unit\": \"%s\"}\n",
           program, measure, compiler, value, reference, value / reference, unit);
}

void bench_compare(const struct bench_row *row)
{
    enum { PASSES = 3 };
    bench_pass *const passes[PASSES] = {row->generated, row->by_hand, row->by_hand_as_it_comes};
    static double times[PASSES][ROUNDS];
    double medians[PASSES];
    for (size_t round = 0; round < ROUNDS; round++) {
        /* who goes first changes from round to round */
        for (size_t turn = 0; turn < PASSES; turn++) {
            const size_t who = (round + turn) % PASSES;
            times[who][round] = time_of(passes[who]);
        }
    }
    for (size_t who = 0; who < PASSES; who++)
        medians[who] = median(times[who], ROUNDS);
    print(row->program, "step time", medians[0], medians[1], "ns");
    print(row->program, "step time, dt as it comes", medians[0], medians[2], "ns");
    print(row->program, "state", (double)row->generated_bytes, (double)row->by_hand_bytes,
          "bytes");
}

void bench_equal(const char *program, size_t instant, double generated, double by_hand)
{
    if (memcmp(&generated, &by_hand, sizeof generated) != 0 && generated != by_hand) {
        fprintf(stderr, "%s: instant %lu: generated %.17g, by hand %.17g\n", program,
                (unsigned long)instant, generated, by_hand);
        exit(1);
    }
}
