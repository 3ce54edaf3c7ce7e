/* Measures the cost for a host of publishing an instant of 1 kB (runtime/hosts/common/ring.h),
 * with a reader in another process. Measures a million instants one by one; the times include
 * that of reading the clock. */
#include "ring.h"

#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { INPUT = 768, OUTPUT = 128, TRUTH = 128, COUNT = 1000000 };

static double now_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec * 1e9 + (double)now.tv_nsec;
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void read_all(const struct ring *ring)
{
    static double input[INPUT / 8], output[OUTPUT / 8], truth[TRUTH / 8];
    uint64_t k = 0;
    int64_t time_ns;
    while (!ring_has_ended(ring)) {
        const struct timespec pause = { 0, 1000000 };
        enum ring_status status = ring_read(ring, k, &time_ns, input, output, truth);
        if (status == RING_NOT_YET)
            nanosleep(&pause, NULL);
        else
            k = status == RING_READ ? k + 1 : ring_count(ring) - 1;
    }
    _exit(0);
}

int main(void)
{
    static double input[INPUT / 8], output[OUTPUT / 8], truth[TRUTH / 8], took[COUNT];
    const struct ring_sizes sizes = { INPUT, OUTPUT, TRUTH };
    struct ring ring;
    pid_t reader;
    if (!ring_make(&ring, &sizes, 0))
        return 1;
    reader = fork();
    if (reader == 0)
        read_all(&ring);
    for (int k = 0; k < COUNT; k++) {
        const double before = now_ns();
        ring_publish(&ring, k, input, output, truth);
        took[k] = now_ns() - before;
    }
    ring_end(&ring, RING_AT_REST);
    waitpid(reader, NULL, 0);
    qsort(took, COUNT, sizeof *took, by_size);
    printf("{\"program\": \"ring\", \"measure\": \"publish 1 kB, median\", \"compiler\": \"\", "
           "\"value\": %.0f, \"reference\": 1000, \"ratio\": %.2f, \"unit\": \"ns\"}\n",
           took[COUNT / 2], took[COUNT / 2] / 1000);
    printf("{\"program\": \"ring\", \"measure\": \"publish 1 kB, 99.9 %%\", \"compiler\": \"\", "
           "\"value\": %.0f, \"reference\": 1000, \"ratio\": %.2f, \"unit\": \"ns\"}\n",
           took[COUNT / 1000 * 999], took[COUNT / 1000 * 999] / 1000);
    return 0;
}
