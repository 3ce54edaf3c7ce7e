#include "publisher.h"

#include "child.h"
#include "frames.h"

#include <frob/camera.h>

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define PATIENCE_NS INT64_C(2000000000) /* maximum time to wait for a silent viewer */

static void warn(const char *what)
{
    fprintf(stderr,
            "warning: this run cannot be viewed: %s: %s; the run continues without a viewer\n",
            what, strerror(errno));
}

/* Executes the viewer, in the child process, with the signal mask and descriptors that a shell
 * would give it. */
static void become(char **command, int file, pid_t host)
{
    sigset_t none;
    child_ends_with(host, SIGTERM);
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
    fcntl(file, F_SETFD, 0);
    execv(command[0], command);
    warn(command[0]);
    _exit(2);
}

/* Returns the viewer's process id, or -1 on failure. */
static pid_t start(const struct ring *ring, char *const *viewer)
{
    const pid_t host = getpid();
    size_t count = 0;
    char number[16];
    char **command;
    pid_t child;
    while (viewer[count] != NULL)
        count++;
    command = (char **)calloc(count + 3, sizeof *command);
    if (command == NULL)
        return -1;
    snprintf(number, sizeof number, "%d", ring->file);
    command[0] = viewer[0];
    command[1] = (char *)"--ring";
    command[2] = number;
    memcpy(command + 3, viewer + 1, (count - 1) * sizeof *command);
    fflush(NULL);
    child = fork();
    if (child == 0)
        become(command, ring->file, host);
    free(command);
    return child;
}

void publisher_start(struct publisher *p, const struct frob_program *program, size_t truth_size,
                     unsigned permissions, char *const *viewer)
{
    const struct ring_sizes sizes = { (uint32_t)program->input_size, (uint32_t)program->output_size,
                                      (uint32_t)truth_size };
    memset(p, 0, sizeof *p);
    if (viewer == NULL)
        return;
    p->program = program;
    if (frames_has_images(program->input) &&
        (p->input = (unsigned char *)malloc(program->input_size)) == NULL) {
        warn("not enough memory for a copy of the input");
        return;
    }
    if (!ring_make(&p->ring, &sizes, permissions)) {
        warn("cannot create shared memory");
        return;
    }
    ring_show_alive(&p->ring);
    p->viewer = start(&p->ring, viewer);
    if (p->viewer <= 0) {
        warn("cannot start a process");
        p->viewer = 0;
        ring_close(&p->ring);
    }
}

static void to_key(void *context, const struct frob_image **image)
{
    const struct frob_frame_name name = frob_frame_name_of(*image);
    const uintptr_t key = (uintptr_t)frames_key(&name);
    (void)context;
    memcpy(image, &key, sizeof key);
}

void publisher_put(struct publisher *p, int64_t time_ns, const void *input, const void *output,
                   const void *truth)
{
    if (p->input != NULL) {
        memcpy(p->input, input, p->program->input_size);
        frob_camera_images(p->program->input, p->input, to_key, NULL);
        input = p->input;
    }
    ring_publish(&p->ring, time_ns, input, output, truth);
}

bool publisher_is_heard(struct publisher *p, int64_t now_ns)
{
    const uint32_t beats = ring_pace(&p->ring).beats;
    if (beats != p->beats) {
        p->beats = beats;
        p->heard_ns = now_ns;
    }
    return p->heard_ns != 0 && now_ns - p->heard_ns < PATIENCE_NS;
}

void publisher_end(struct publisher *p, enum ring_fate fate)
{
    ring_end(&p->ring, fate);
    free(p->input);
    p->input = NULL;
}

static int64_t clock_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * 1000000000 + now.tv_nsec;
}

/* Waits for a signal in the set, for at most a fifth of a second. */
static int next_signal(const sigset_t *set)
{
    static const struct timespec moment = { 0, 200000000 };
    return sigtimedwait(set, NULL, &moment);
}

static bool has_ended(struct publisher *p)
{
    if (p->viewer > 0 && waitpid(p->viewer, NULL, WNOHANG) != 0)
        p->viewer = 0;
    return p->viewer == 0;
}

/* Closes the output streams, so that their readers do not have to wait until the page is
 * closed. */
static void tell_that_it_stays(void)
{
    const int null = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (isatty(STDERR_FILENO))
        fprintf(stderr,
                "The run is over. Its page stays open until you close it or press Ctrl-C.\n");
    fflush(NULL);
    if (null >= 0) {
        dup2(null, STDOUT_FILENO);
        dup2(null, STDERR_FILENO);
        close(null);
    }
}

void publisher_leave(struct publisher *p, bool is_wanted)
{
    enum { TELLS_AFTER = 3, GOES_WITHIN = 10, BEGINS_WITHIN = 50 }; /* in fifths of a second */
    sigset_t awaited;
    sigemptyset(&awaited);
    sigaddset(&awaited, SIGCHLD);
    sigaddset(&awaited, SIGINT);
    sigaddset(&awaited, SIGTERM);
    sigaddset(&awaited, SIGHUP);
    sigprocmask(SIG_BLOCK, &awaited, NULL);
    for (int waited = 0; is_wanted && !has_ended(p); waited++) {
        const int number = next_signal(&awaited);
        const bool is_heard =
            publisher_is_heard(p, clock_ns()) || (p->heard_ns == 0 && waited < BEGINS_WITHIN);
        is_wanted = (number < 0 || number == SIGCHLD) && is_heard;
        if (waited == TELLS_AFTER)
            tell_that_it_stays();
    }
    if (p->viewer > 0)
        kill(p->viewer, SIGTERM);
    for (int waited = 0; waited < GOES_WITHIN && !has_ended(p); waited++)
        next_signal(&awaited);
    if (p->viewer > 0) {
        kill(p->viewer, SIGKILL);
        waitpid(p->viewer, NULL, 0);
        p->viewer = 0;
    }
    ring_close(&p->ring);
}
