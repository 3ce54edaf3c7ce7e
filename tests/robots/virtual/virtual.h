/* virtual.h -- virtual time for tests: the memory that the clock (clock.c) and the processes of a test
 * (virtual.c) share.
 *
 * The time stands still while any of these processes has work to do. When all wait, it jumps to the
 * end of the first wait. So a run takes the same steps on a busy machine as on an idle one. */
#ifndef FROB_TESTS_VIRTUAL_H
#define FROB_TESTS_VIRTUAL_H

#include <stdbool.h>
#include <stdint.h>
#include <sys/types.h>

enum { PROCESSES = 256, WAITS = 256 };

/* A thread that waits until a time, or for something that happens earlier. */
struct virtual_wait {
    pid_t process, thread; /* 0: this entry is free */
    uint32_t number;       /* of its waits so far */
    int32_t waits;         /* whether it waits now */
    int64_t until_ns;
};

/* All members are accessed atomically. */
struct virtual_time {
    int64_t now_ns;
    int32_t forks;              /* processes that are being created */
    pid_t processes[PROCESSES]; /* 0: this entry is free */
    struct virtual_wait waits[WAITS];
};

#endif
