/* usage: clock_host PROGRAM.so COUNT PERIOD_US PRIORITY [VIEWER ARGUMENT...]
 *
 * A host that does nothing but keep time. It runs COUNT instants of clock.frob, one every
 * PERIOD_US, and publishes them as all hosts do, with or without a viewer. The input is the
 * wall-clock time of publication in milliseconds, and the number of microseconds by which the
 * process woke up late. With a PRIORITY it runs under SCHED_FIFO with this priority. At the end
 * it prints the median and the 99 % quantile of the lateness, excluding the first second. */
#include "load.h"
#include "publisher.h"

#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static double seconds(clockid_t clock)
{
    struct timespec now;
    clock_gettime(clock, &now);
    return (double)now.tv_sec + (double)now.tv_nsec / 1e9;
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

int main(int argc, char **argv)
{
    const struct frob_program *program = argc < 5 ? NULL : frob_load(argv[1]);
    const long count = argc < 5 ? 0 : atol(argv[2]), period_us = argc < 5 ? 0 : atol(argv[3]);
    const long first = period_us == 0 ? 0 : 1000000 / period_us;
    const struct sched_param priority = { .sched_priority = argc < 5 ? 0 : atoi(argv[4]) };
    struct publisher publisher;
    struct timespec wake;
    double input[2] = { 0.0, 0.0 }, *late;
    void *state, *output;
    if (program == NULL || count <= first || program->input_size != sizeof input)
        return 2;
    state = calloc(1, program->state_size + 1);
    output = calloc(1, program->output_size + 1);
    late = (double *)calloc((size_t)count, sizeof *late);
    if (state == NULL || output == NULL || late == NULL)
        return 2;
    publisher_start(&publisher, program, 0, RING_PACES, argc > 5 ? argv + 5 : NULL);
    if (priority.sched_priority > 0 && sched_setscheduler(0, SCHED_FIFO, &priority) != 0)
        fprintf(stderr, "warning: no real-time priority is allowed\n");
    program->reset(state, program->default_params);
    clock_gettime(CLOCK_MONOTONIC, &wake);
    for (long k = 0; k < count && !(argc > 5 && ring_is_stopped(&publisher.ring)); k++) {
        wake.tv_nsec += period_us * 1000;
        wake.tv_sec += wake.tv_nsec / 1000000000;
        wake.tv_nsec %= 1000000000;
        clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, NULL);
        late[k] =
            (seconds(CLOCK_MONOTONIC) - (double)wake.tv_sec - (double)wake.tv_nsec / 1e9) * 1e6;
        input[0] = seconds(CLOCK_REALTIME) * 1e3;
        input[1] = late[k];
        const int64_t dt_ns = k == 0 ? 0 : (int64_t)period_us * 1000;
        program->step(state, program->default_params, dt_ns, (double)dt_ns / 1e9, input, output);
        if (argc > 5)
            ring_publish(&publisher.ring, k * period_us * 1000, input, output, NULL);
    }
    publisher_end(&publisher, RING_AT_REST);
    publisher_leave(&publisher, false);
    qsort(late + first, (size_t)(count - first), sizeof *late, by_size);
    printf("late: %.1f %.1f\n", late[first + (count - first) / 2],
           late[first + (count - first) * 99 / 100]);
    return 0;
}
