#include "bench.h"
#include "by_hand.h"

BENCH(weak_modes)

static void make_input(size_t i)
{
    input[i].front = 0.2 + 2.0 * bench_random();
    input[i].side = 0.3 + 0.6 * bench_random();
    input[i].bump = bench_chance(0.01);
}
