#include "capture.h"

#include "../common/child.h"
#include "source.h"
#include "tagger.h"

#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#define RETRY_NS INT64_C(500000000)
#define SILENT_NS INT64_C(1000000000) /* shortest gap between frames that is reported */
#define BEGIN_NS INT64_C(5000000)     /* delay before the first recorded frame */
enum { WAIT_MS = 100, HANGS_MS = 4000 };

struct capture {
    const struct camera_options *options;
    const struct capture_way *way;
    struct buffers *buffers; /* way->seen */
    int socket;
    struct source source;
    bool is_open;
    int64_t opened_ns, frame_ns; /* time of opening, and time of the last good frame (0: none) */
    int64_t period_ns;           /* time between frames if none is missing; 0: unknown */
    int64_t same_ns;             /* time at which the frames last changed */
    int32_t width, height;       /* size of all frames; 0 until the first frame sets it */
    enum frob_image_format format;
    uint32_t number; /* number of the next good frame */
    struct capture_report told;
    bool has_told;
};

static void report(struct capture *c, enum capture_state state, const char *text)
{
    if (c->has_told && c->told.state == state &&
        (state == CAPTURE_WORKS || strcmp(c->told.text, text) == 0))
        return;
    memset(&c->told, 0, sizeof c->told);
    c->told.state = state;
    snprintf(c->told.text, sizeof c->told.text, "%s", text);
    c->has_told = true;
    while (send(c->socket, &c->told, sizeof c->told, MSG_NOSIGNAL) < 0)
        if (errno != EINTR)
            _exit(0);
}

/* Returns how long frames may be missing: three periods, but at least a second. */
static int64_t patience_ns(const struct capture *c)
{
    return 3 * c->period_ns > SILENT_NS ? 3 * c->period_ns : SILENT_NS;
}

/* Reports a fault only after a while without frames, because one or two missing frames are
 * normal. */
static void complain(struct capture *c, const char *text)
{
    if (c->frame_ns == 0 || source_now_ns() - c->frame_ns > patience_ns(c))
        report(c, CAPTURE_FAILS, text);
}

/* Updates the period between frames. The period decreases immediately but increases slowly: a few
 * missing frames do not mean that the camera is slow, and they must not lengthen the timeout for
 * the next frame. */
static void take_period(struct capture *c, int64_t since_ns)
{
    if (c->period_ns == 0 || since_ns < c->period_ns)
        c->period_ns = since_ns;
    else
        c->period_ns += (since_ns - c->period_ns) / 8;
}

static bool is_silent(const struct capture *c)
{
    const int64_t since = c->frame_ns > c->opened_ns ? c->frame_ns : c->opened_ns;
    return source_now_ns() - since > patience_ns(c);
}

static void leave(struct capture *c)
{
    if (c->is_open)
        c->source.kind->close(&c->source);
    c->is_open = false;
}

/* Opens the source. Its kind may have changed since the last time; for example, a file that did not
 * exist may now be a pipe. */
static bool enter(struct capture *c)
{
    c->source.kind = source_kind_of(c->options->source);
    c->source.fault[0] = c->source.what[0] = '\0';
    c->source.is_recorded = false;
    c->is_open = c->source.kind->open(&c->source);
    c->opened_ns = source_now_ns();
    return c->is_open;
}

/* ---- Frames */

static bool is_same(const struct captured *a, const struct captured *b)
{
    return b != NULL && a->width == b->width && a->height == b->height && a->format == b->format &&
           memcmp(a->pixels, b->pixels,
                  (size_t)a->width * (size_t)a->height *
                      (size_t)frob_image_pixel_size(a->format)) == 0;
}

/* Returns whether a camera's frames have been bit-for-bit identical for too long. Such a camera is
 * frozen, because the images of a working camera contain noise. */
static bool is_frozen(struct capture *c, const struct captured *frame)
{
    const double limit_s = c->options->settings[CAMERA_FROZEN];
    const int64_t now = source_now_ns();
    if (limit_s <= 0.0 || !is_same(frame, buffers_published(c->buffers))) {
        c->same_ns = now;
        return false;
    }
    return (double)(now - c->same_ns) > limit_s * 1e9;
}

static bool is_right_size(struct capture *c, const struct captured *frame)
{
    if (c->width == 0 || c->height == 0) {
        c->width = frame->width;
        c->height = frame->height;
    }
    if (c->number == 0)
        c->format = frame->format;
    return frame->width == c->width && frame->height == c->height && frame->format == c->format;
}

static const char *name_of(enum frob_image_format format)
{
    return format == FROB_GREY8 ? "grey" : "colours";
}

static void describe(const struct capture *c, const struct captured *frame, char text[640])
{
    const double *s = c->options->settings;
    const struct frob_camera seen = frame->has_camera
                                        ? frame->camera
                                        : camera_geometry(c->options, frame->width, frame->height);
    snprintf(text, 640,
             "%d x %d, %s%s%s; focal length %.0f px%s, %.2f m ahead, %.2f m to the left, %.2f m "
             "up, tilted down by %.0f degrees",
             (int)frame->width, (int)frame->height, name_of(frame->format),
             c->source.what[0] != '\0' ? ", " : "", c->source.what, seen.focal_x,
             frame->has_camera         ? " from the frame's header"
             : s[CAMERA_FOCAL_X] > 0.0 ? ""
                                       : " from its field of view",
             seen.x_m, seen.y_m, seen.z_m, seen.pitch_rad * 57.295779513082323);
}

/* Rejects a frame. The reason stays in `fault` until the next good frame. */
static void refuse(struct capture *c)
{
    c->source.lost++;
    complain(c, c->source.fault);
}

static void got_frame(struct capture *c, struct captured *frame)
{
    char text[640];
    const int64_t now = source_now_ns();
    frame->number = c->number + c->source.lost;
    if (!is_right_size(c, frame)) {
        source_fail(&c->source, SOURCE_BROKEN,
                    "a frame is %d x %d, %s, instead of %d x %d, %s: set width, height and grey to "
                    "the camera's format, or configure the camera for the expected format",
                    (int)frame->width, (int)frame->height, name_of(frame->format), (int)c->width,
                    (int)c->height, name_of(c->format));
        refuse(c);
        return;
    }
    if (is_frozen(c, frame)) {
        source_fail(&c->source, SOURCE_BROKEN,
                    "it is frozen: all its frames are identical; unplug it and "
                    "plug it in again, or set frozen=0 if identical frames are correct");
        refuse(c);
        return;
    }
    frame->captured_ns -= (int64_t)(c->options->settings[CAMERA_LATENCY] * 1e9);
    describe(c, frame, text);
    c->number++;
    buffers_publish(c->buffers);
    if (c->frame_ns != 0 && c->told.state == CAPTURE_WORKS)
        take_period(c, now - c->frame_ns);
    c->frame_ns = now;
    c->source.fault[0] = '\0';
    report(c, CAPTURE_WORKS, text);
}

/* Handles a missing frame. If frames have been missing for too long, reports why, and reopens the
 * source if that may help. */
static void got_nothing(struct capture *c)
{
    if (!is_silent(c))
        return;
    complain(c, c->source.fault[0] != '\0' ? c->source.fault : c->source.kind->silence);
    if (c->source.kind->reopens)
        leave(c);
}

static void pause_until_ns(struct capture *c, int64_t until)
{
    while (source_now_ns() < until) {
        buffers_beat(c->buffers);
        source_sleep_until_ns(source_now_ns() + WAIT_MS * INT64_C(1000000));
    }
}

static void step(struct capture *c)
{
    buffers_beat(c->buffers);
    if (!c->is_open && !enter(c)) {
        complain(c, c->source.fault);
        pause_until_ns(c, source_now_ns() + RETRY_NS);
        return;
    }
    if (c->source.is_recorded && !buffers_have_begun(c->way->given)) {
        source_sleep_until_ns(source_now_ns() + BEGIN_NS);
        return;
    }
    switch (c->source.kind->next(&c->source, buffers_back(c->buffers), WAIT_MS)) {
    case SOURCE_FRAME: got_frame(c, buffers_back(c->buffers)); break;
    case SOURCE_BROKEN:
        c->source.lost++;
        /* fall through */
    case SOURCE_NOTHING: got_nothing(c); break;
    case SOURCE_FAULT:
        leave(c);
        complain(c, c->source.fault);
        pause_until_ns(c, source_now_ns() + RETRY_NS);
        break;
    case SOURCE_OVER:
        report(c, CAPTURE_ENDED, c->source.fault);
        for (;;)
            pause_until_ns(c, source_now_ns() + RETRY_NS);
    }
}

/* ---- Processes */

/* Ignores signals from the terminal, which the supervisor handles, and makes this process end when
 * its parent does. */
static void belong_to(pid_t parent)
{
    sigset_t none;
    signal(SIGINT, SIG_IGN);
    signal(SIGHUP, SIG_IGN);
    signal(SIGTSTP, SIG_IGN);
    signal(SIGPIPE, SIG_IGN);
    signal(SIGTERM, SIG_DFL);
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, NULL);
    child_ends_with(parent, SIGKILL);
}

/* Captures frames forever. After a restart it continues with the previous frame's number and
 * size. */
static void work(struct capture *c, pid_t keeper) __attribute__((noreturn));

static void work(struct capture *c, pid_t keeper)
{
    const struct captured *before = buffers_published(c->buffers);
    belong_to(keeper);
    if (before != NULL) {
        c->number = before->number + 1;
        c->width = before->width;
        c->height = before->height;
        c->format = before->format;
    }
    for (;;)
        step(c);
}

/* A child process whose heartbeat is monitored. */
struct watched {
    pid_t process;
    const struct buffers *beats_for;
    const char *what, *hanging;
    uint32_t beats;
    int hangs_ms;
};

/* Returns true in the new process. */
static bool start(struct watched *w)
{
    w->process = fork();
    return w->process == 0;
}

static void end_all(struct watched *each, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (each[i].process > 0) {
            kill(each[i].process, SIGKILL);
            waitpid(each[i].process, NULL, 0);
        }
}

/* Kills a process that hangs. */
static void look_after(struct watched *w)
{
    const uint32_t beats = buffers_beats(w->beats_for);
    w->hangs_ms = beats == w->beats ? w->hangs_ms + WAIT_MS : 0;
    w->beats = beats;
    if (w->hangs_ms == HANGS_MS)
        kill(w->process, SIGKILL);
}

static void tell_end(struct capture *c, const struct watched *w, int status)
{
    char text[640];
    if (w->hangs_ms >= HANGS_MS)
        snprintf(text, sizeof text, "%s: restarting it", w->hanging);
    else if (WIFSIGNALED(status))
        snprintf(text, sizeof text, "%s was killed by signal %d (%s); restarting it", w->what,
                 WTERMSIG(status), strsignal(WTERMSIG(status)));
    else
        snprintf(text, sizeof text, "%s has ended; restarting it", w->what);
    c->has_told = false;
    report(c, CAPTURE_FAILS, text);
}

/* Watches the processes until one of them ends. */
static void watch(struct capture *c, struct watched *each, size_t count)
{
    for (;;) {
        struct pollfd gone = { c->socket, POLLIN, 0 };
        for (size_t i = 0; i < count; i++) {
            int status = 0;
            if (waitpid(each[i].process, &status, WNOHANG) != 0) {
                each[i].process = 0;
                tell_end(c, &each[i], status);
                return;
            }
        }
        if (poll(&gone, 1, WAIT_MS) > 0)
            _exit(0);
        for (size_t i = 0; i < count; i++)
            look_after(&each[i]);
    }
}

void capture_run(const struct camera_options *options, const struct capture_way *way, int socket,
                 pid_t supervisor)
{
    struct capture c;
    const pid_t keeper = getpid();
    belong_to(supervisor);
    memset(&c, 0, sizeof c);
    c.options = c.source.options = options;
    c.way = way;
    c.buffers = way->seen;
    c.socket = socket;
    c.width = (int32_t)options->settings[CAMERA_WIDTH];
    c.height = (int32_t)options->settings[CAMERA_HEIGHT];
    for (;;) {
        struct watched each[2] = { { 0, way->seen, "its capture process",
                                     "its capture process hangs in a system call", 0, 0 },
                                   { 0, way->given, "its tag detector", "its tag detector hangs", 0,
                                     0 } };
        const size_t count = way->finder != NULL ? 2 : 1;
        if (start(&each[0]))
            work(&c, keeper);
        if (count == 2 && start(&each[1])) {
            belong_to(keeper);
            tagger_run(way->finder, way->seen, way->given);
        }
        if (each[0].process > 0 && (count == 1 || each[1].process > 0))
            watch(&c, each, count);
        end_all(each, count);
        source_sleep_until_ns(source_now_ns() + RETRY_NS);
    }
}
