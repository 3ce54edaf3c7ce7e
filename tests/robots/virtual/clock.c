/* usage: clock FILE MOST : the clock of virtual time (virtual.h), in a new file. Its time runs at most
 * MOST times as fast as real time. It ends after the process that started it, and after all processes
 * that use it. */
#define _GNU_SOURCE
#include "virtual.h"

#include <dirent.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <time.h>
#include <unistd.h>

#define LOAD(place) __atomic_load_n(&(place), __ATOMIC_SEQ_CST)
#define STORE(place, value) __atomic_store_n(&(place), value, __ATOMIC_SEQ_CST)

enum { THREADS = 1024 };

/* A thread that was found asleep. */
struct asleep {
    pid_t thread;
    uint64_t runs; /* how often it waited, or how often it ran */
};

static struct virtual_time *shared;
static double most;         /* the maximum rate of the time */
static int64_t advanced_ns; /* the real time when it advanced last */

static int64_t real_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * 1000000000 + now.tv_nsec;
}

/* Reads a file of /proc. Returns false if it does not exist. */
static bool read_file(const char *path, char *text, size_t room)
{
    const int file = open(path, O_RDONLY | O_CLOEXEC);
    const ssize_t length = file < 0 ? -1 : read(file, text, room - 1);
    if (file >= 0)
        close(file);
    text[length > 0 ? length : 0] = '\0';
    return length > 0;
}

/* The state of a process or thread: R for one that runs; X if it has ended. */
static char state_of(const char *folder)
{
    char path[80], text[400];
    const char *name_end;
    snprintf(path, sizeof path, "%s/stat", folder);
    if (!read_file(path, text, sizeof text))
        return 'X';
    name_end = strrchr(text, ')');
    return name_end != NULL ? name_end[2] : 'X';
}

static struct virtual_wait *wait_of(pid_t thread)
{
    for (size_t i = 0; i < WAITS; i++)
        if (LOAD(shared->waits[i].thread) == thread)
            return &shared->waits[i];
    return NULL;
}

/* How often a thread has run so far. */
static uint64_t runs_of(const char *folder)
{
    char path[80], text[200];
    unsigned long long runs = 0;
    snprintf(path, sizeof path, "%s/schedstat", folder);
    if (read_file(path, text, sizeof text) && sscanf(text, "%*u %*u %llu", &runs) != 1)
        return 0;
    return runs;
}

/* Adds a thread. Returns false if it runs, or is to run. */
static bool add_thread(pid_t process, pid_t thread, struct asleep *found, size_t *count)
{
    const struct virtual_wait *wait = wait_of(thread);
    char folder[60], state;
    snprintf(folder, sizeof folder, "/proc/%d/task/%d", (int)process, (int)thread);
    state = state_of(folder);
    if (state == 'X' || state == 'Z')
        return true;
    /* A stopped one does not run, whatever it waits for. */
    if (strchr("STt", state) == NULL || *count == THREADS)
        return false;
    found[*count].thread = thread;
    if (wait != NULL && LOAD(wait->waits) != 0 && state == 'S') {
        if (LOAD(wait->until_ns) <= LOAD(shared->now_ns))
            return false;
        found[*count].runs = LOAD(wait->number);
    } else {
        found[*count].runs = (UINT64_C(1) << 32) + runs_of(folder);
    }
    (*count)++;
    return true;
}

static bool add_process(pid_t process, struct asleep *found, size_t *count)
{
    char path[40];
    DIR *folder;
    bool ok = true;
    snprintf(path, sizeof path, "/proc/%d/task", (int)process);
    folder = opendir(path);
    for (struct dirent *entry = folder != NULL ? readdir(folder) : NULL; entry != NULL && ok;
         entry = readdir(folder))
        if (entry->d_name[0] != '.')
            ok = add_thread(process, (pid_t)atoi(entry->d_name), found, count);
    if (folder != NULL)
        closedir(folder);
    return ok;
}

/* Finds all threads asleep. Returns false if one is not. Removes the processes that have ended. */
static bool all_sleep(struct asleep *found, size_t *count)
{
    *count = 0;
    if (LOAD(shared->forks) != 0)
        return false;
    for (size_t i = 0; i < PROCESSES; i++) {
        const pid_t process = LOAD(shared->processes[i]);
        char folder[40], state;
        if (process == 0)
            continue;
        snprintf(folder, sizeof folder, "/proc/%d", (int)process);
        state = state_of(folder);
        if (state == 'X' || state == 'Z')
            STORE(shared->processes[i], 0);
        else if (!add_process(process, found, count))
            return false;
    }
    return true;
}

/* Returns the end of the first wait; INT64_MAX if no thread waits. */
static int64_t first_end(void)
{
    int64_t first = INT64_MAX;
    for (size_t i = 0; i < WAITS; i++) {
        struct virtual_wait *wait = &shared->waits[i];
        const pid_t thread = LOAD(wait->thread), process = LOAD(wait->process);
        char folder[60];
        if (thread == 0 || process == 0)
            continue;
        snprintf(folder, sizeof folder, "/proc/%d/task/%d", (int)process, (int)thread);
        switch (state_of(folder)) {
        case 'X':
        case 'Z':
            STORE(wait->waits, 0);
            STORE(wait->process, 0);
            STORE(wait->thread, 0);
            break;
        case 'T':
        case 't': break;
        /* A waiting thread runs now and then, to look at the time. */
        default:
            if (LOAD(wait->waits) != 0 && LOAD(wait->until_ns) < first)
                first = LOAD(wait->until_ns);
        }
    }
    return first;
}

/* Advances the time if no thread runs. Between the two looks at a thread that finds it in the same
 * sleep, there is a moment that is the same for all threads: the end of the first round. */
static void advance(void)
{
    static struct asleep before[THREADS], after[THREADS];
    size_t count, again;
    int64_t first;
    if (!all_sleep(before, &count) || !all_sleep(after, &again) || count != again ||
        memcmp(before, after, count * sizeof *before) != 0)
        return;
    first = first_end();
    if (first == INT64_MAX || first <= LOAD(shared->now_ns))
        return;
    if ((double)(first - LOAD(shared->now_ns)) > most * (double)(real_ns() - advanced_ns))
        return;
    advanced_ns = real_ns();
    STORE(shared->now_ns, first);
}

static bool is_used(void)
{
    for (size_t i = 0; i < PROCESSES; i++)
        if (LOAD(shared->processes[i]) != 0)
            return true;
    return false;
}

int main(int argc, char **argv)
{
    static const struct timespec pause = { 0, 200000 };
    const pid_t parent = getppid();
    int file = argc == 3 ? open(argv[1], O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0600) : -1;
    void *memory = file < 0 || ftruncate(file, sizeof *shared) != 0
                       ? MAP_FAILED
                       : mmap(NULL, sizeof *shared, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (memory == MAP_FAILED) {
        fprintf(stderr, "usage: clock FILE MOST\n");
        return 2;
    }
    shared = (struct virtual_time *)memory;
    most = atof(argv[2]);
    advanced_ns = real_ns();
    STORE(shared->now_ns, INT64_C(1000000000000));
    puts("started");
    fflush(stdout);
    while (getppid() == parent || is_used()) {
        advance();
        nanosleep(&pause, NULL);
    }
    return 0;
}
