#include "bench.h"
#include "by_hand.h"

BENCH(patrol)

/* Occasional bumps; the way is clear again after a while. */
static void make_input(size_t i)
{
    input[i].bump = bench_chance(0.02);
    input[i].side = 0.3 + 0.4 * bench_random();
    input[i].front = 0.5 + 0.105 * bench_random();
}
