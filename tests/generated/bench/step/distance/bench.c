#include "bench.h"
#include "by_hand.h"

BENCH(distance)

static void make_input(size_t i)
{
    input[i].f1 = 0.5 * bench_random();
    input[i].f2 = 0.2 + 2.0 * bench_random();
    input[i].f3 = 0.3 + 0.6 * bench_random();
}
