#include "cameras.h"

#include <errno.h>
#include <math.h>
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
    while (i < count &&
           (strlen(options[i].label) != length || strncmp(options[i].label, label, length) != 0))
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
            fprintf(stderr, "error: %s uses more cameras than the maximum of %d for a robot\n",
                    program->name, CAMERAS_MOST);
            return false;
        }
        if (at == *count && !camera_options_init(&options[(*count)++], control->label, length))
            return false;
        options[at].has_tags = options[at].has_tags || control->kind == FROB_TAGS;
    }
    return true;
}

/* ---- Starting and ending */

static bool start(struct cameras *all, struct camera *c)
{
    const pid_t supervisor = getpid();
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
        capture_run(c->options, &c->way, sockets[1], supervisor);
    }
    close(sockets[1]);
    c->socket = sockets[0];
    if (c->process < 0)
        fprintf(stderr, "error: cannot start a camera: %s\n", strerror(errno));
    return c->process > 0;
}

static struct camera *labelled(struct cameras *c, const char *label)
{
    for (size_t i = 0; i < c->count; i++)
        if (strcmp(c->each[i].options->label, label) == 0)
            return &c->each[i];
    return NULL;
}

static void pair_up(struct cameras *c)
{
    struct stereo_pair *s = &c->stereo;
    struct camera *left = labelled(c, "left"), *right = labelled(c, "right");
    if (left != NULL && right != NULL) {
        const double *one = left->options->settings, *other = right->options->settings;
        s->left = left;
        s->right = right;
        pair_init(&s->pair, 1.0 / fmax(one[CAMERA_RATE], other[CAMERA_RATE]),
                  fmin(one[CAMERA_PAIR_WITHIN], other[CAMERA_PAIR_WITHIN]));
    }
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
    pair_up(c);
    return true;
}

/* Kills the process. A process blocked in a system call may not end, so this waits only for a
 * limited time. */
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

/* ---- Messages */

static void tell(const struct cameras *all, struct camera *c, const struct capture_report *said)
{
    const char *label = c->options->label, *source = c->options->source;
    if (said->state == CAPTURE_WORKS) {
        snprintf(c->seen, sizeof c->seen, "%s", said->text);
        if (c->has_failed && !c->works)
            fprintf(stderr, "camera `%s` (%s) delivers frames again\n", label, source);
        else if (all->tells)
            fprintf(stderr, "camera `%s` (%s): %s\n", label, source, said->text);
        c->works = true;
        return;
    }
    if (c->works || !c->has_failed)
        c->failures++;
    c->works = false;
    c->has_failed = true;
    fprintf(stderr, "warning: camera `%s` (%s) delivers no frames%s: %s\n", label, source,
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
        snprintf(said.text, sizeof said.text, "its process has ended");
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

/* Reports when the two cameras have delivered no pairs for too long, and when they deliver pairs
 * again. */
static void tell_pair(struct stereo_pair *s, bool is_pair, int64_t without_ns)
{
    const struct pair *p = &s->pair;
    const double period_ns = fmax(p->rhythms[0].period_ns, p->rhythms[1].period_ns);
    if (is_pair && s->has_failed)
        fprintf(stderr, "cameras `left` and `right` deliver pairs of frames again\n");
    if (is_pair)
        s->has_failed = false;
    if (is_pair || s->has_failed || p->nearest_ns == INT64_MAX ||
        (double)without_ns <= fmax(1e9, 3.0 * period_ns))
        return;
    s->has_failed = true;
    s->failures++;
    fprintf(stderr,
            "warning: cameras `left` and `right` deliver no pairs of frames: the closest frames "
            "were taken %.0f ms apart, but the maximum is %.0f ms (%s): ",
            (double)p->nearest_ns * 1e-6, (double)pair_most_ns(p) * 1e-6,
            pair_most_ns(p) == p->within_ns ? "pair_within" : "0.6 periods");
    fprintf(stderr,
            "make both cameras take frames at the same time and rate%s; if the frames of one "
            "camera arrive later, set its latency to the difference\n",
            pair_most_ns(p) == p->within_ns ? ", or increase pair_within" : "");
}

/* Warns if the cameras are at the same position, which makes depths impossible to compute. */
static void check_seats(const struct stereo_pair *s)
{
    const struct frob_camera *l = &buffers_image(s->left->way.given)->camera;
    const struct frob_camera *r = &buffers_image(s->right->way.given)->camera;
    if (fabs(l->x_m - r->x_m) + fabs(l->y_m - r->y_m) + fabs(l->z_m - r->z_m) < 0.001)
        fprintf(stderr, "warning: cameras `left` and `right` have the same position, so no depth "
                        "can be computed: set their positions, such as `--set left.left=0.06 --set "
                        "right.left=-0.06` for two cameras that are 12 cm apart\n");
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
    if (all->stereo.left != NULL) {
        const struct pair *p = &all->stereo.pair;
        printf("pairs: %lu\n", (unsigned long)p->count);
        if (p->count > 0)
            printf("time between the frames of a pair: %.1f ms on average, %.1f ms at most\n",
                   p->apart_ns / p->count * 1e-6, (double)p->most_ns * 1e-6);
        printf("pair failures: %lu\n", (unsigned long)all->stereo.failures);
    }
}

/* ---- Frames */

/* Fills in the image. Validates what the camera process reports about the frame, because that
 * process may be corrupted. */
static bool describe(struct camera *c, const struct captured *frame, int64_t first_ns)
{
    struct frob_image *image = buffers_image(c->way.given);
    image->width = frame->width;
    image->height = frame->height;
    image->format = frame->format;
    if ((image->format != FROB_GREY8 && image->format != FROB_RGB8) || image->width < 1 ||
        image->width > FROB_IMAGE_SIDE || image->height < 1 || image->height > FROB_IMAGE_SIDE)
        return false;
    image->stride = image->width * frob_image_pixel_size(image->format);
    if ((size_t)image->stride * (size_t)image->height > BUFFERS_ROOM)
        return false;
    image->pixels = frame->pixels;
    image->captured_ns = frame->captured_ns - first_ns;
    image->number = frame->number;
    image->camera = camera_geometry(c->options, image->width, image->height);
    if (frame->has_camera)
        image->camera = frame->camera;
    c->given++;
    c->last_number = frame->number;
    return true;
}

/* Passes a frame from this camera to the program, or tells it that there is none. */
static void give(const struct cameras *all, struct camera *c, const struct captured *frame,
                 void *input, int64_t first_ns, int64_t now_ns)
{
    const struct frob_program *program = all->program;
    const char *label = c->options->label;
    const bool has_frame = frame != NULL && describe(c, frame, first_ns);
    const struct frob_image *image = has_frame ? buffers_image(c->way.given) : NULL;
    for (size_t i = 0; i < program->control_count; i++) {
        const struct frob_control *control = &program->console[i];
        const size_t length = frob_camera_label(control);
        if (length == 0 || length != strlen(label) || strncmp(control->label, label, length) != 0)
            continue;
        if (control->kind == FROB_CAMERA)
            frob_camera_give(control, input, image, now_ns);
        else
            frob_tags_give(control, input, image, has_frame ? &frame->tags : NULL, now_ns);
    }
}

void cameras_look(struct cameras *c, void *input, int64_t first_ns, int64_t now_ns)
{
    struct stereo_pair *s = &c->stereo;
    for (size_t k = 0; k < c->count; k++) {
        struct camera *camera = &c->each[k];
        buffers_begin(camera->way.given);
        if (camera != s->left && camera != s->right)
            give(c, camera, buffers_take(camera->way.given), input, first_ns, now_ns);
    }
    if (s->left != NULL) {
        struct buffers *const both[2] = { s->left->way.given, s->right->way.given };
        const struct captured *frames[2] = { NULL, NULL };
        const bool is_pair = pair_take(&s->pair, both, frames);
        give(c, s->left, is_pair ? frames[0] : NULL, input, first_ns, now_ns);
        give(c, s->right, is_pair ? frames[1] : NULL, input, first_ns, now_ns);
        if (is_pair && s->pair.count == 1)
            check_seats(s);
        if (is_pair || !s->left->works || !s->right->works || s->paired_ns == 0)
            s->paired_ns = first_ns + now_ns;
        tell_pair(s, is_pair, first_ns + now_ns - s->paired_ns);
    }
}
