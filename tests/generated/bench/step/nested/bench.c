#include "bench.h"
#include "by_hand.h"

BENCH(nested)

/* The robot is on duty most of the time; obstacles come and go. */
static void make_input(size_t i)
{
    static bool duty;
    static double front = 2.0;
    if (bench_chance(duty ? 0.002 : 0.05))
        duty = !duty;
    front += 0.3 * (bench_random() - 0.5);
    if (front < 0.2 || front > 3.0)
        front = 2.0;
    input[i].duty = duty;
    input[i].front = front;
}
