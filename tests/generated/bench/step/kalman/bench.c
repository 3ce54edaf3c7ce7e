#include "bench.h"
#include "by_hand.h"

BENCH(kalman)

/* Along a wall at about half a metre; now and then somebody passes. */
static void make_input(size_t i)
{
    input[i].went = 0.01 * bench_random();
    input[i].turned = 0.002 * (bench_random() - 0.5);
    input[i].wall = bench_chance(0.02) ? 2.0 + bench_random() : 0.45 + 0.1 * bench_random();
}
