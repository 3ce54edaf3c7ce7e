#include "bench.h"
#include "by_hand.h"

#include <math.h>

BENCH(bug)

/* The robot drives around a circle that moves towards the goal and away from it, and looks
 * around; sometimes there is an obstacle ahead. */
static void make_input(size_t i)
{
    const double angle = 0.01 * (double)i;
    input[i].x = 3.0 + 0.6 * sin(angle) + 0.01 * bench_random();
    input[i].y = 0.2 + 0.2 * sin(0.11 * angle) + 0.6 * cos(angle) + 0.01 * bench_random();
    input[i].heading = atan2(1.0 - input[i].y, 3.0 - input[i].x) + bench_random() - 0.5;
    input[i].speed = 0.35 * bench_random();
    input[i].ahead = bench_chance(0.005) ? 0.3 * bench_random() : 0.3 + bench_random();
    input[i].side = bench_chance(0.9) ? 0.2 + 0.2 * bench_random() : 3.0;
}
