#include "publisher.h"

#include "frames.h"

#include <frob/camera.h>

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define PATIENCE_NS INT64_C(2000000000) /* with a viewer that is not heard */

static void warn(const char *what)
{
    fprintf(stderr, "warning: this run cannot be looked at: %s: %s; it goes on without\n", what,
            strerror(errno));
}

/* The process: as a shell would start it. */
static void become(char **command, int file)
{
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
    fcntl(file, F_SETFD, 0);
    execv(command[0], command);
    warn(command[0]);
    _exit(2);
}

static bool start(const struct ring *ring, char *const *viewer)
{
    size_t count = 0;
    char number[16];
    char **command;
    pid_t child;
    while (viewer[count] != NULL)
        count++;
    command = (char **)calloc(count + 3, sizeof *command);
    if (command == NULL)
        return false;
    snprintf(number, sizeof number, "%d", ring->file);
    command[0] = viewer[0];
    command[1] = (char *)"--ring";
    command[2] = number;
    memcpy(command + 3, viewer + 1, (count - 1) * sizeof *command);
    fflush(NULL);
    child = fork();
    if (child == 0)
        become(command, ring->file);
    free(command);
    return child > 0;
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
        warn("its frames");
        return;
    }
    if (!ring_make(&p->ring, &sizes, permissions)) {
        warn("there is no shared memory");
    } else if (!start(&p->ring, viewer)) {
        warn("no process can be started");
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

void publisher_end(struct publisher *p)
{
    ring_end(&p->ring);
    ring_close(&p->ring);
    free(p->input);
    p->input = NULL;
}
