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
#include <frob/tags.h>

static size_t find(const struct camera_options *options, size_t count, const char *label,
                   size_t length)
{
    size_t i = 0;
    while (i < count && (strlen(options[i].label) != length ||
                         strncmp(options[i].label, label, length) != 0))
        i++;
    return i;
}

bool cameras_options(struct camera_options options[CAMERAS_MOST], size_t *count,
                     const struct frob_program *program)
{
    *count = 0;
    for (size_t i = 0; i < program->control_count; i++) {
        const struct frob_control *control = &program->console[i];
        const size_t length = frob_camera_label(control);
        const size_t at = find(options, *count, control->label, length);
        if (length == 0)
            continue;
        if (at == CAMERAS_MOST) {
            fprintf(stderr, "error: %s asks for more than %d cameras, which is as many as a robot "
                            "may have\n", program->name, CAMERAS_MOST);
            return false;
        }
        if (at == *count && !camera_options_init(&options[(*count)++], control->label, length))
            return false;
        options[at].has_tags = options[at].has_tags || control->kind == FROB_TAGS;
    }
    return true;
}

/* {1 Starting and ending} */

static bool start(struct cameras *all, struct camera *c)
{
    int sockets[2];
    c->socket = -1;
    c->last_number = -1;
    c->way.seen = c->way.given = buffers_make();
    if (c->options->has_tags) {
        c->way.finder = &all->finder;
        c->way.given = buffers_make();
    }
    if (c->way.seen == NULL || c->way.given == NULL ||
        socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, sockets) != 0) {
        fprintf(stderr, "error: cannot start a camera: %s\n", strerror(errno));
        return false;
    }
    fflush(NULL);
    c->process = fork();
    if (c->process == 0) {
        close(sockets[0]);
        capture_run(c->options, &c->way, sockets[1]);
    }
    close(sockets[1]);
    c->socket = sockets[0];
    if (c->process < 0)
        fprintf(stderr, "error: cannot start a camera: %s\n", strerror(errno));
    return c->process > 0;
}

bool cameras_start(struct cameras *c, const struct frob_program *program,
                   const struct camera_options *options, size_t count, bool tells)
{
    memset(c, 0, sizeof *c);
    c->program = program;
    c->tells = tells;
    for (size_t i = 0; i < count; i++) {
        c->each[i].options = &options[i];
        if (options[i].has_tags && c->finder.detector == NULL && !tag_finder_open(&c->finder))
            return false;
        c->count++;
        if (!start(c, &c->each[i]))
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
    if (c->way.given != NULL && c->way.given != c->way.seen)
        buffers_free(c->way.given);
    if (c->way.seen != NULL)
        buffers_free(c->way.seen);
}

void cameras_end(struct cameras *c)
{
    for (size_t i = 0; i < c->count; i++)
        end(&c->each[i]);
    c->count = 0;
    tag_finder_close(&c->finder);
}

/* {1 Frames} */

/* The process may have gone mad: what it says of a frame is looked at before anybody uses it. */
static const struct captured *take(struct camera *c, struct frob_image *image, int64_t first_ns)
{
    const struct captured *frame = buffers_take(c->way.given);
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
    return frame;
}

void cameras_look(struct cameras *c, void *input, int64_t first_ns, int64_t now_ns)
{
    const struct frob_program *program = c->program;
    for (size_t k = 0; k < c->count; k++) {
        struct camera *camera = &c->each[k];
        const char *label = camera->options->label;
        struct frob_image *image = buffers_image(camera->way.given);
        const struct captured *frame;
        buffers_begin(camera->way.given);
        frame = take(camera, image, first_ns);
        for (size_t i = 0; i < program->control_count; i++) {
            const struct frob_control *control = &program->console[i];
            const size_t length = frob_camera_label(control);
            if (length == 0 || length != strlen(label) ||
                strncmp(control->label, label, length) != 0)
                continue;
            if (control->kind == FROB_CAMERA)
                frob_camera_give(control, input, frame != NULL ? image : NULL, now_ns);
            else
                frob_tags_give(control, input, frame != NULL ? image : NULL,
                               frame != NULL ? &frame->tags : NULL, now_ns);
        }
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
