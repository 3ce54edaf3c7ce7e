#include "cameras.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <frob/camera.h>

#include "capture.h"

bool cameras_options(struct camera_options options[CAMERAS_MOST], size_t *count,
                     const struct frob_program *program)
{
    *count = 0;
    for (size_t i = 0; i < program->control_count; i++) {
        if (program->console[i].kind != FROB_CAMERA)
            continue;
        if (*count == CAMERAS_MOST) {
            fprintf(stderr, "error: %s asks for more than %d cameras, which is as many as a robot "
                            "may have\n", program->name, CAMERAS_MOST);
            return false;
        }
        camera_options_init(&options[(*count)++], program->console[i].label);
    }
    return true;
}

/* {1 Starting and ending} */

static bool start(struct camera *c)
{
    int sockets[2];
    c->socket = -1;
    c->last_number = -1;
    c->buffers = buffers_make();
    if (c->buffers == NULL ||
        socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, sockets) != 0) {
        fprintf(stderr, "error: cannot start a camera: %s\n", strerror(errno));
        return false;
    }
    fflush(NULL);
    c->process = fork();
    if (c->process == 0) {
        close(sockets[0]);
        capture_run(c->options, c->buffers, sockets[1]);
    }
    close(sockets[1]);
    c->socket = sockets[0];
    if (c->process < 0)
        fprintf(stderr, "error: cannot start a camera: %s\n", strerror(errno));
    return c->process > 0;
}

bool cameras_start(struct cameras *c, const struct frob_program *program,
                   const struct camera_options *options, bool tells)
{
    memset(c, 0, sizeof *c);
    c->tells = tells;
    for (size_t i = 0; i < program->control_count; i++) {
        struct camera *camera = &c->each[c->count];
        if (program->console[i].kind != FROB_CAMERA)
            continue;
        camera->control = &program->console[i];
        camera->options = &options[c->count++];
        if (!start(camera))
            return false;
    }
    return true;
}

/* A process in a call of the system that does not come back cannot be waited for. */
static void end(struct camera *c)
{
    static const struct timespec pause = { 0, 1000000 };
    if (c->process > 0) {
        kill(c->process, SIGKILL);
        for (int ms = 0; ms < 200 && waitpid(c->process, NULL, WNOHANG) == 0; ms++)
            nanosleep(&pause, NULL);
    }
    if (c->socket >= 0)
        close(c->socket);
    if (c->buffers != NULL)
        buffers_free(c->buffers);
}

void cameras_end(struct cameras *c)
{
    for (size_t i = 0; i < c->count; i++)
        end(&c->each[i]);
    c->count = 0;
}

/* {1 Frames} */

/* The process may have gone mad: what it says of a frame is looked at before anybody uses it. */
static const struct frob_image *take(struct camera *c, int64_t first_ns)
{
    struct frob_image *image = buffers_image(c->buffers);
    const struct captured *frame = buffers_take(c->buffers);
    if (frame == NULL)
        return NULL;
    image->width = frame->width;
    image->height = frame->height;
    image->format = frame->format;
    if ((image->format != FROB_GREY8 && image->format != FROB_RGB8) || image->width < 1 ||
        image->width > FROB_IMAGE_SIDE || image->height < 1 || image->height > FROB_IMAGE_SIDE)
        return NULL;
    image->stride = image->width * frob_image_pixel_size(image->format);
    if ((size_t)image->stride * (size_t)image->height > BUFFERS_ROOM)
        return NULL;
    image->pixels = frame->pixels;
    image->captured_ns = frame->captured_ns - first_ns;
    image->number = frame->number;
    image->camera = camera_geometry(c->options, image->width, image->height);
    if (frame->has_camera)
        image->camera = frame->camera;
    c->given++;
    c->last_number = frame->number;
    return image;
}

void cameras_look(struct cameras *c, void *input, int64_t first_ns, int64_t now_ns)
{
    for (size_t i = 0; i < c->count; i++) {
        buffers_begin(c->each[i].buffers);
        frob_camera_give(c->each[i].control, input, take(&c->each[i], first_ns), now_ns);
    }
}

/* {1 What is told} */

static void tell(const struct cameras *all, struct camera *c, const struct capture_report *said)
{
    const char *label = c->options->label, *source = c->options->source;
    if (said->state == CAPTURE_WORKS) {
        snprintf(c->seen, sizeof c->seen, "%s", said->text);
        if (c->has_failed && !c->works)
            fprintf(stderr, "camera `%s` (%s) gives frames again\n", label, source);
        else if (all->tells)
            fprintf(stderr, "camera `%s` (%s): %s\n", label, source, said->text);
        c->works = true;
        return;
    }
    if (c->works || !c->has_failed)
        c->failures++;
    c->works = false;
    c->has_failed = true;
    fprintf(stderr, "warning: camera `%s` (%s) gives no frames%s: %s\n", label, source,
            said->state == CAPTURE_ENDED ? " any more" : "", said->text);
}

static void hear(const struct cameras *all, struct camera *c)
{
    struct capture_report said;
    ssize_t got = 1;
    while (c->socket >= 0 && got > 0) {
        got = recv(c->socket, &said, sizeof said, MSG_DONTWAIT);
        if (got == (ssize_t)sizeof said) {
            said.text[sizeof said.text - 1] = '\0';
            tell(all, c, &said);
        }
    }
    if (c->socket >= 0 && got == 0) {
        memset(&said, 0, sizeof said);
        said.state = CAPTURE_ENDED;
        snprintf(said.text, sizeof said.text, "its process is gone");
        tell(all, c, &said);
        close(c->socket);
        c->socket = -1;
    }
}

void cameras_hear(struct cameras *c)
{
    for (size_t i = 0; i < c->count; i++)
        hear(c, &c->each[i]);
}

void cameras_print(const struct cameras *all)
{
    for (size_t i = 0; i < all->count; i++) {
        const struct camera *c = &all->each[i];
        const char *label = c->options->label;
        printf("%s: %s\n", label, c->seen[0] != '\0' ? c->seen : "no frames");
        printf("%s frames: %lu\n", label, (unsigned long)c->given);
        printf("%s frames not seen: %lu\n", label,
               (unsigned long)(c->last_number + 1 - (int64_t)c->given));
        printf("%s failures: %lu\n", label, (unsigned long)c->failures);
    }
}
