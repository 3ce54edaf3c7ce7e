#include "bench.h"
#include "by_hand.h"

BENCH(pid)

/* The output is at its limits part of the time. */
static void make_input(size_t i)
{
    input[i].value = 1.2 * (bench_random() - 0.5);
}
