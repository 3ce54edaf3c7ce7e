#include "bench.h"
#include "by_hand.h"

BENCH(events)

/* A button that bounces and is sometimes held down. */
static void make_input(size_t i)
{
    static bool held;
    if (bench_chance(0.05))
        held = !held;
    input[i].button = bench_chance(0.1) ? !held : held;
    input[i].temperature = 290.0 + 10.0 * bench_random();
}
