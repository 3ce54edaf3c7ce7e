#include "guard.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { STOP_PERIOD_MS = 100, LAST_WORDS = 3 };

static void pause_ms(long ms)
{
    struct timespec pause;
    pause.tv_sec = 0;
    pause.tv_nsec = ms * 1000000;
    nanosleep(&pause, NULL);
}

/* The process. What it knows of the robot is as it was when it was started;
 * a driver's stop is good in any state. */
static void watch(int pipe, struct frob_robot *robot, int patience_ms)
{
    for (;;) {
        struct pollfd heard = { pipe, POLLIN, 0 };
        char beats[64];
        ssize_t got;
        int n = poll(&heard, 1, patience_ms);
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
    for (int i = 0; i < LAST_WORDS; i++) {
        frob_robot_halt(robot);
        pause_ms(STOP_PERIOD_MS);
    }
    _exit(0);
}

void guard_start(struct guard *g, struct frob_robot *robot, int64_t patience_ns, int closes)
{
    int ends[2];
    memset(g, 0, sizeof *g);
    g->pipe = -1;
    if (pipe2(ends, O_CLOEXEC) != 0) {
        fprintf(stderr, "warning: there is no guard: %s\n", strerror(errno));
        return;
    }
    fflush(NULL);
    g->pid = fork();
    if (g->pid == 0) {
        /* Not in the group of the terminal: nothing from there ends it. */
        setsid();
        for (int number = 1; number < 32; number++)
            if (number != SIGKILL && number != SIGSTOP && number != SIGCHLD)
                signal(number, SIG_IGN);
        close(ends[1]);
        close(closes);
        watch(ends[0], robot, (int)(patience_ns / 1000000));
    }
    close(ends[0]);
    if (g->pid < 0) {
        fprintf(stderr, "warning: there is no guard: %s\n", strerror(errno));
        close(ends[1]);
        g->pid = 0;
        return;
    }
    fcntl(ends[1], F_SETFL, O_NONBLOCK);
    g->pipe = ends[1];
}

void guard_hear(const struct guard *g)
{
    /* A pipe that is full has been heard often enough; a guard that is gone
     * is no reason to stop. */
    if (g->pid != 0 && write(g->pipe, "", 1) < 0)
        return;
}

void guard_end(struct guard *g)
{
    if (g->pid == 0)
        return;
    kill(g->pid, SIGKILL);
    while (waitpid(g->pid, NULL, 0) < 0 && errno == EINTR)
        continue;
    close(g->pipe);
    g->pid = 0;
}
