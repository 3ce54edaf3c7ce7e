#include "controller.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "../common/child.h"
#include "realtime.h"
#include <frob/program.h>

/* A message with this dt resets the program and gets no answer. */
#define RESETS INT64_MIN

/* Exit status of the controller process if the program's state is not valid. */
enum { STATE_IS_DAMAGED = 3 };

/* The controller process: runs a step for each message, until the supervisor is gone. */
static void serve(const struct controller *c, int socket, const struct params *params)
{
    const struct frob_program *program = params->program;
    void *state = calloc(1, program->state_size + 1);
    void *input = calloc(1, program->input_size + 1);
    void *output = calloc(1, program->output_size + 1);
    if (state == NULL || input == NULL || output == NULL) {
        fprintf(stderr, "error: not enough memory for the program's state\n");
        _exit(2);
    }
    program->reset(state, params->values);
    bool is_first = true;
    for (;;) {
        int64_t dt_ns;
        ssize_t got = recv(socket, c->message, sizeof dt_ns + c->input_size, 0);
        if (got < 0 && errno == EINTR)
            continue;
        if (got != (ssize_t)(sizeof dt_ns + c->input_size))
            _exit(0);
        memcpy(&dt_ns, c->message, sizeof dt_ns);
        if (dt_ns == RESETS) {
            memset(state, 0, program->state_size);
            program->reset(state, params->values);
            is_first = true;
            continue;
        }
        memcpy(input, c->message + sizeof dt_ns, c->input_size);
        if (is_first)
            dt_ns = 0;
        is_first = false;
        memset(output, 0, program->output_size);
        if (!program->is_valid(state))
            _exit(STATE_IS_DAMAGED);
        program->step(state, params->values, dt_ns, (double)dt_ns / 1e9, input, output);
        while (send(socket, output, c->output_size, MSG_NOSIGNAL) < 0)
            if (errno != EINTR)
                _exit(0);
    }
}

/* Ignores signals from the terminal, which the supervisor handles. */
static void leave_signals_to_supervisor(pid_t supervisor)
{
    sigset_t none;
    signal(SIGINT, SIG_IGN);
    signal(SIGHUP, SIG_IGN);
    signal(SIGTSTP, SIG_IGN);
    signal(SIGTERM, SIG_DFL);
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
    child_ends_with(supervisor, SIGKILL);
}

bool controller_start(struct controller *c, const struct params *params,
                      const struct options *options)
{
    const struct frob_program *program = params->program;
    int sockets[2];
    pid_t supervisor;
    size_t room =
        sizeof(int64_t) +
        (program->input_size > program->output_size ? program->input_size : program->output_size);
    memset(c, 0, sizeof *c);
    c->socket = -1;
    c->input_size = program->input_size;
    c->output_size = program->output_size;
    c->message = (char *)malloc(room);
    if (c->message == NULL || socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, sockets) != 0) {
        fprintf(stderr, "error: cannot start the controller: %s\n", strerror(errno));
        return false;
    }
    fflush(NULL);
    supervisor = getpid();
    c->pid = fork();
    if (c->pid < 0) {
        fprintf(stderr, "error: cannot start the controller: %s\n", strerror(errno));
        c->pid = 0;
        return false;
    }
    if (c->pid == 0) {
        close(sockets[0]);
        leave_signals_to_supervisor(supervisor);
        realtime_apply(options, REALTIME_CONTROLLER);
        serve(c, sockets[1], params);
    }
    close(sockets[1]);
    c->socket = sockets[0];
    return true;
}

bool controller_ask(struct controller *c, int64_t dt_ns, const void *input)
{
    const size_t size = sizeof dt_ns + c->input_size;
    memcpy(c->message, &dt_ns, sizeof dt_ns);
    memcpy(c->message + sizeof dt_ns, input, c->input_size);
    return send(c->socket, c->message, size, MSG_NOSIGNAL | MSG_DONTWAIT) >= 0;
}

bool controller_reset(struct controller *c, const void *input)
{
    return controller_ask(c, RESETS, input);
}

enum controller_answer controller_take(struct controller *c, void *output)
{
    ssize_t got = recv(c->socket, c->message, c->output_size, MSG_DONTWAIT);
    if (got < 0 && (errno == EAGAIN || errno == EINTR))
        return CONTROLLER_BUSY;
    if (got != (ssize_t)c->output_size)
        return CONTROLLER_GONE;
    memcpy(output, c->message, c->output_size);
    return CONTROLLER_ANSWERED;
}

const char *controller_end(struct controller *c, int patience_ms)
{
    static char fate[256];
    int status = 0;
    pid_t gone = 0;
    if (c->pid == 0)
        return NULL;
    /* A process that ends closes its socket slightly before waitpid can report its
     * end. */
    for (int ms = 0; gone == 0 && ms <= patience_ms; ms++) {
        static const struct timespec pause = { 0, 1000000 };
        gone = waitpid(c->pid, &status, WNOHANG);
        if (gone == 0 && ms < patience_ms)
            nanosleep(&pause, NULL);
    }
    if (gone == 0) {
        kill(c->pid, SIGKILL);
        while (waitpid(c->pid, &status, 0) < 0 && errno == EINTR)
            continue;
    }
    c->pid = 0;
    close(c->socket);
    free(c->message);
    if (WIFSIGNALED(status) && !(gone == 0 && WTERMSIG(status) == SIGKILL))
        snprintf(fate, sizeof fate, "was killed by signal %d (%s)", WTERMSIG(status),
                 strsignal(WTERMSIG(status)));
    else if (WIFSIGNALED(status))
        snprintf(fate, sizeof fate, "was killed");
    else if (WEXITSTATUS(status) == STATE_IS_DAMAGED)
        snprintf(fate, sizeof fate, "found its state damaged: " FROB_DAMAGED_STATE);
    else
        snprintf(fate, sizeof fate, "ended with status %d", WEXITSTATUS(status));
    return fate;
}
