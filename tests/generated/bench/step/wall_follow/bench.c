#include "bench.h"
#include "by_hand.h"

BENCH(wall_follow)

/* The output is at its limits part of the time. */
static void make_input(size_t i)
{
    input[i].f1 = 0.4 * bench_random();
    input[i].f2 = 0.1 + bench_random();
    input[i].f3 = 0.1 + 0.3 * bench_random();
}
