#include "bench.h"
#include "by_hand.h"

BENCH(obstacles)

/* Some readings are near, most are far. */
static void make_input(size_t i)
{
    for (size_t k = 0; k < 16; k++)
        input[i].sonar[k] = bench_chance(0.3) ? bench_random() : 1.0 + 2.0 * bench_random();
}
