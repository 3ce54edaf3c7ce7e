#include "bench.h"
#include "by_hand.h"

BENCH(kalman)

/* The robot drives along a wall at a distance of about half a metre; sometimes a person passes
   between them. */
static void make_input(size_t i)
{
    input[i].went = 0.01 * bench_random();
    input[i].turned = 0.002 * (bench_random() - 0.5);
    input[i].wall = bench_chance(0.02) ? 2.0 + bench_random() : 0.45 + 0.1 * bench_random();
}
