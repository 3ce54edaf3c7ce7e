/* Virtual time: when this library is preloaded into the processes of a test, their monotonic clock and
 * their waits follow the time in the file FROB_VIRTUAL, which the program of clock.c advances. */
#define _GNU_SOURCE
#include "virtual.h"

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#define LOAD(place) __atomic_load_n(&(place), __ATOMIC_SEQ_CST)
#define STORE(place, value) __atomic_store_n(&(place), value, __ATOMIC_SEQ_CST)

/* How often a waiting thread looks at the time. */
static const struct timespec glance = { 0, 1000000 };

static struct virtual_time *shared; /* NULL: time is real */
static __thread struct virtual_wait *own_wait;

static void *next(const char *name)
{
    return dlsym(RTLD_NEXT, name);
}

static bool claim(pid_t *place, pid_t value)
{
    pid_t none = 0;
    return __atomic_compare_exchange_n(place, &none, value, false, __ATOMIC_SEQ_CST,
                                       __ATOMIC_SEQ_CST);
}

static void enter_process(void)
{
    const pid_t self = getpid();
    for (size_t i = 0; i < PROCESSES; i++)
        if (LOAD(shared->processes[i]) == self)
            return;
    for (size_t i = 0; i < PROCESSES; i++)
        if (claim(&shared->processes[i], self))
            return;
    abort();
}

static void before_fork(void)
{
    __atomic_add_fetch(&shared->forks, 1, __ATOMIC_SEQ_CST);
}

static void in_child(void)
{
    own_wait = NULL;
    enter_process();
    __atomic_sub_fetch(&shared->forks, 1, __ATOMIC_SEQ_CST);
}

/* fork() may fail, without calling a handler of the child. */
pid_t fork(void)
{
    pid_t (*original)(void) = (pid_t(*)(void))next("fork");
    pid_t child;
    if (shared == NULL)
        return original();
    before_fork();
    child = original();
    if (child == 0)
        in_child();
    if (child < 0)
        __atomic_sub_fetch(&shared->forks, 1, __ATOMIC_SEQ_CST);
    return child;
}

__attribute__((constructor)) static void enter(void)
{
    const char *name = getenv("FROB_VIRTUAL");
    int file = name != NULL ? open(name, O_RDWR | O_CLOEXEC) : -1;
    void *memory = file < 0
                       ? MAP_FAILED
                       : mmap(NULL, sizeof *shared, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (file >= 0)
        close(file);
    if (memory == MAP_FAILED)
        return;
    shared = (struct virtual_time *)memory;
    enter_process();
}

static int64_t to_ns(const struct timespec *time)
{
    return (int64_t)time->tv_sec * 1000000000 + time->tv_nsec;
}

static struct timespec of_ns(int64_t ns)
{
    struct timespec time = { (time_t)(ns / 1000000000), (long)(ns % 1000000000) };
    return time;
}

static struct virtual_wait *wait_of_thread(void)
{
    const pid_t thread = (pid_t)syscall(SYS_gettid);
    for (size_t i = 0; own_wait == NULL && i < WAITS; i++)
        if (claim(&shared->waits[i].thread, thread)) {
            own_wait = &shared->waits[i];
            STORE(own_wait->process, getpid());
        }
    if (own_wait == NULL)
        abort();
    return own_wait;
}

/* Waits for files until a time. `mask`: the signals that are blocked meanwhile, NULL: as before. */
static int wait_until(struct pollfd *files, nfds_t count, int64_t until_ns, const sigset_t *mask)
{
    int (*original)(struct pollfd *, nfds_t, const struct timespec *, const sigset_t *) =
        (int (*)(struct pollfd *, nfds_t, const struct timespec *, const sigset_t *))next("ppoll");
    struct virtual_wait *wait = wait_of_thread();
    int result = 0;
    STORE(wait->until_ns, until_ns);
    STORE(wait->number, wait->number + 1);
    STORE(wait->waits, 1);
    while (result == 0 && LOAD(shared->now_ns) < until_ns)
        result = original(files, count, &glance, mask);
    /* Nothing may have happened at the end of the wait. */
    if (result == 0) {
        static const struct timespec none;
        result = original(files, count, &none, mask);
    }
    STORE(wait->waits, 0);
    return result;
}

int clock_gettime(clockid_t clock, struct timespec *time)
{
    int (*original)(clockid_t, struct timespec *) =
        (int (*)(clockid_t, struct timespec *))next("clock_gettime");
    if (shared == NULL || clock != CLOCK_MONOTONIC)
        return original(clock, time);
    *time = of_ns(LOAD(shared->now_ns));
    return 0;
}

int clock_nanosleep(clockid_t clock, int flags, const struct timespec *time, struct timespec *left)
{
    int (*original)(clockid_t, int, const struct timespec *, struct timespec *) = (int (*)(
        clockid_t, int, const struct timespec *, struct timespec *))next("clock_nanosleep");
    int64_t until_ns;
    if (shared == NULL || (clock != CLOCK_MONOTONIC && flags != 0))
        return original(clock, flags, time, left);
    until_ns = flags != 0 ? to_ns(time) : LOAD(shared->now_ns) + to_ns(time);
    if (wait_until(NULL, 0, until_ns, NULL) >= 0)
        return 0;
    if (left != NULL && flags == 0)
        *left = of_ns(until_ns - LOAD(shared->now_ns));
    return errno;
}

int nanosleep(const struct timespec *time, struct timespec *left)
{
    int (*original)(const struct timespec *, struct timespec *) =
        (int (*)(const struct timespec *, struct timespec *))next("nanosleep");
    int result;
    if (shared == NULL)
        return original(time, left);
    result = clock_nanosleep(CLOCK_MONOTONIC, 0, time, left);
    errno = result;
    return result == 0 ? 0 : -1;
}

int ppoll(struct pollfd *files, nfds_t count, const struct timespec *time, const sigset_t *mask)
{
    int (*original)(struct pollfd *, nfds_t, const struct timespec *, const sigset_t *) =
        (int (*)(struct pollfd *, nfds_t, const struct timespec *, const sigset_t *))next("ppoll");
    if (shared == NULL || time == NULL || to_ns(time) == 0)
        return original(files, count, time, mask);
    return wait_until(files, count, LOAD(shared->now_ns) + to_ns(time), mask);
}

int poll(struct pollfd *files, nfds_t count, int wait_ms)
{
    const struct timespec time = { wait_ms / 1000, wait_ms % 1000 * 1000000L };
    return ppoll(files, count, wait_ms < 0 ? NULL : &time, NULL);
}
