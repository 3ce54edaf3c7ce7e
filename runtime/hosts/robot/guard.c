#include "guard.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "hal/posix/clock.h"

/* APART_MS: delay of the second guard, so that the packets of the two guards do not interleave. */
enum { STOP_PERIOD_MS = 100, LAST_WORDS = 3, APART_MS = 50 };

#define HANGS_NS INT64_C(1000000000)
#define RETRY_NS INT64_C(1000000000)

static int64_t now_ns(void)
{
    return frob_now_ns(&frob_posix_clock);
}

static void pause_ms(long ms)
{
    struct timespec pause;
    pause.tv_sec = 0;
    pause.tv_nsec = ms * 1000000;
    nanosleep(&pause, NULL);
}

/* ---- The process */

/* Runs the guard. Its copy of the robot's state is as old as the guard itself, but a driver's stop
 * function works in any state. */
static void watch(int pipe, struct frob_robot *robot, int patience_ms, int after_ms)
{
    for (;;) {
        struct pollfd heard = { pipe, POLLIN, 0 };
        char beats[64];
        ssize_t got;
        int n = poll(&heard, 1, patience_ms + after_ms);
        if (n == 0) {
            frob_robot_halt(robot);
            pause_ms(STOP_PERIOD_MS);
            continue;
        }
        got = n < 0 ? -1 : read(pipe, beats, sizeof beats);
        if (got == 0)
            break;
        if (got < 0 && errno != EINTR)
            break;
    }
    pause_ms(after_ms);
    for (int i = 0; i < LAST_WORDS; i++) {
        frob_robot_halt(robot);
        pause_ms(STOP_PERIOD_MS);
    }
    _exit(0);
}

/* A pipe reports end-of-file only when no process has its write end open, so this process must
 * close its copies of the write ends. */
static void become_guard(const struct guards *g, size_t i, const int ends[2])
{
    /* Leaves the terminal's session, so that signals from the terminal do not end the guard. */
    setsid();
    for (int number = 1; number < 32; number++)
        if (number != SIGKILL && number != SIGSTOP && number != SIGCHLD)
            signal(number, SIG_IGN);
    close(ends[1]);
    close(g->closes);
    for (size_t k = 0; k < GUARDS; k++)
        if (g->each[k].pid != 0)
            close(g->each[k].pipe);
    watch(ends[0], g->robot, (int)(g->patience_ns / 1000000), (int)i * APART_MS);
}

/* ---- The supervisor's side */

static bool start(struct guards *g, size_t i)
{
    struct guard *guard = &g->each[i];
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
        return false;
    fflush(NULL);
    guard->pid = fork();
    if (guard->pid == 0)
        become_guard(g, i, ends);
    close(ends[0]);
    if (guard->pid < 0) {
        close(ends[1]);
        guard->pid = 0;
        return false;
    }
    fcntl(ends[1], F_SETFL, O_NONBLOCK);
    guard->pipe = ends[1];
    guard->awake_ns = now_ns();
    return true;
}

/* Starts the missing guards. */
static void start_missing(struct guards *g)
{
    for (size_t i = 0; i < GUARDS; i++) {
        if (g->each[i].pid == 0 && !start(g, i)) {
            fprintf(stderr, "warning: cannot start a guard process: %s\n", strerror(errno));
            g->retry_ns = now_ns() + RETRY_NS;
            return;
        }
    }
}

void guards_start(struct guards *g, struct frob_robot *robot, int64_t patience_ns, int closes)
{
    memset(g, 0, sizeof *g);
    g->robot = robot;
    g->patience_ns = patience_ns;
    g->closes = closes;
    start_missing(g);
}

/* Checks whether a guard hangs: a working guard empties its pipe before the next heartbeat. */
static bool hangs(struct guard *guard)
{
    int unread = 0;
    if (ioctl(guard->pipe, FIONREAD, &unread) != 0 || unread == 0)
        guard->awake_ns = now_ns();
    return now_ns() - guard->awake_ns > HANGS_NS;
}

static void end(struct guard *guard, int *status)
{
    kill(guard->pid, SIGKILL);
    while (waitpid(guard->pid, status, 0) < 0 && errno == EINTR)
        continue;
    close(guard->pipe);
    guard->pid = 0;
}

/* Returns whether the guard is gone; if so, prints why. */
static bool is_gone(struct guard *guard)
{
    int status = 0;
    if (waitpid(guard->pid, &status, WNOHANG) == guard->pid) {
        close(guard->pipe);
        guard->pid = 0;
        if (WIFSIGNALED(status))
            fprintf(stderr,
                    "warning: a guard process was killed by signal %d (%s); starting another one\n",
                    WTERMSIG(status), strsignal(WTERMSIG(status)));
        else
            fprintf(stderr, "warning: a guard process ended with status %d; starting another one\n",
                    WEXITSTATUS(status));
    } else if (hangs(guard)) {
        end(guard, NULL);
        fprintf(stderr, "warning: a guard process hangs; starting another one\n");
    }
    return guard->pid == 0;
}

void guards_hear(struct guards *g)
{
    bool lacks = false;
    if (g->robot == NULL)
        return;
    for (size_t i = 0; i < GUARDS; i++) {
        struct guard *guard = &g->each[i];
        /* If the pipe is full, the guard already has enough heartbeats to read. */
        if (guard->pid == 0 || is_gone(guard) || write(guard->pipe, "", 1) < 0)
            lacks = lacks || guard->pid == 0;
    }
    if (lacks && now_ns() >= g->retry_ns)
        start_missing(g);
}

void guards_end(struct guards *g)
{
    for (size_t i = 0; i < GUARDS; i++)
        if (g->each[i].pid != 0)
            end(&g->each[i], NULL);
    g->robot = NULL;
}
