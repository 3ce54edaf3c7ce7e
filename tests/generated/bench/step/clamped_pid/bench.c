#include "bench.h"
#include "by_hand.h"

BENCH(clamped_pid)

/* A square wave, and a measurement that follows it with noise. */
static void make_input(size_t i)
{
    static double measured;
    const double wanted = i / 256 % 2 == 0 ? 0.6 : -0.6;
    measured += 0.05 * (wanted - measured);
    input[i].f1 = wanted;
    input[i].f2 = measured + 0.02 * (bench_random() - 0.5);
}
