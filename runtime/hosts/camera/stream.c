/* Reads frames from a pipe as they arrive, or from a file at a fixed rate. */
#include "decode.h"
#include "source.h"
#include "splitter.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { READ_MOST = 1 << 16 };

struct stream {
    int file;
    bool is_file; /* whether the source is a file, whose frames are delivered at the set rate */
    int64_t due_ns;
    struct splitter splitter;
};

/* Writes the path of the pipe or file to `path`. The source ros:TOPIC#DESCRIPTOR is an inherited
 * pipe, to which another process writes the topic's images. */
static void path_of(const char *name, char *path, size_t room)
{
    const char *descriptor = strrchr(name, '#');
    if (strncmp(name, SOURCE_TOPIC, strlen(SOURCE_TOPIC)) == 0 && descriptor != NULL)
        snprintf(path, room, "/proc/self/fd/%s", descriptor + 1);
    else
        snprintf(path, room, "%s", name);
}

/* Opens the pipe or file without waiting for a writer. */
static bool open_stream(struct source *s)
{
    char name[4096];
    struct stream *t = (struct stream *)calloc(1, sizeof *t);
    struct stat status;
    if (t == NULL || !splitter_open(&t->splitter, decode_raw_size(s->options))) {
        source_fail(s, SOURCE_FAULT, "not enough memory");
        free(t);
        return false;
    }
    path_of(s->options->source, name, sizeof name);
    t->file = open(name, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (t->file < 0 || fstat(t->file, &status) != 0) {
        source_fail(s, SOURCE_FAULT, "it cannot be opened: %s%s", strerror(errno),
                    errno == ENOENT ? "; create a pipe with mkfifo" : "");
        if (t->file >= 0)
            close(t->file);
        splitter_close(&t->splitter);
        free(t);
        return false;
    }
    t->is_file = S_ISREG(status.st_mode);
    s->is_recorded = t->is_file;
    s->state = t;
    snprintf(s->what, sizeof s->what, "%s", t->splitter.raw_size > 0 ? "raw frames" : "pictures");
    return true;
}

/* Reads the available bytes. If the writer of a pipe closes its end, this process keeps its own end
 * open for the next writer. */
static enum source_result take_in(struct source *s, struct stream *t)
{
    size_t room;
    uint8_t *space = splitter_space(&t->splitter, &room);
    const ssize_t got = read(t->file, space, room < READ_MOST ? room : READ_MOST);
    if (got > 0) {
        splitter_feed(&t->splitter, (size_t)got, source_now_ns());
        return SOURCE_FRAME;
    }
    if (got == 0 && t->is_file)
        return source_fail(s, SOURCE_OVER, "the whole file has been shown");
    if (got == 0) {
        splitter_forget(&t->splitter);
        return source_fail(
            s, SOURCE_NOTHING,
            "no program writes to the pipe: start the program that sends the frames");
    }
    if (errno == EAGAIN || errno == EINTR)
        return SOURCE_NOTHING;
    return source_fail(s, SOURCE_FAULT, "it cannot be read: %s", strerror(errno));
}

static enum source_result decode(struct source *s, struct stream *t, const uint8_t *bytes,
                                 size_t size, struct captured *frame)
{
    const bool is_grey = s->options->settings[CAMERA_GREY] > 0.0;
    const char *fault;
    char message[256];
    if (t->splitter.raw_size > 0) {
        fault = decode_set_size(frame, (int64_t)s->options->settings[CAMERA_WIDTH],
                                (int64_t)s->options->settings[CAMERA_HEIGHT],
                                is_grey ? FROB_GREY8 : FROB_RGB8, message);
        if (fault == NULL)
            memcpy(frame->pixels, bytes, size);
    } else {
        fault = decode_picture(bytes, size, is_grey, frame, message);
    }
    return fault == NULL ? SOURCE_FRAME : source_fail(s, SOURCE_BROKEN, "%s", fault);
}

/* Returns the newest available frame of a pipe, or the next frame of a file. */
static const uint8_t *take(struct source *s, struct stream *t, size_t *size, int64_t *begun_ns)
{
    return t->is_file ? splitter_take(&t->splitter, size, begun_ns)
                      : splitter_take_newest(&t->splitter, size, begun_ns, &s->lost);
}

static enum source_result next(struct source *s, struct captured *frame, int wait_ms)
{
    struct stream *t = (struct stream *)s->state;
    const int64_t until = source_now_ns() + wait_ms * INT64_C(1000000);
    const uint8_t *bytes;
    size_t size;
    if (t->due_ns == 0)
        t->due_ns = source_now_ns();
    if (t->is_file && t->due_ns > until) {
        source_sleep_until_ns(until);
        return SOURCE_NOTHING;
    }
    if (t->is_file)
        source_sleep_until_ns(t->due_ns);
    while ((bytes = take(s, t, &size, &frame->captured_ns)) == NULL) {
        struct pollfd input = { t->file, POLLIN, 0 };
        const int64_t left = until - source_now_ns();
        enum source_result result;
        if (left <= 0)
            return SOURCE_NOTHING;
        if (poll(&input, 1, (int)(left / 1000000) + 1) <= 0)
            continue;
        result = take_in(s, t);
        if (result == SOURCE_NOTHING)
            source_sleep_until_ns(until); /* a pipe without a writer is always ready */
        if (result != SOURCE_FRAME)
            return result;
    }
    if (t->is_file) {
        t->due_ns += (int64_t)(1e9 / s->options->settings[CAMERA_RATE]);
        frame->captured_ns = source_now_ns();
    }
    return decode(s, t, bytes, size, frame);
}

static void close_stream(struct source *s)
{
    struct stream *t = (struct stream *)s->state;
    close(t->file);
    splitter_close(&t->splitter);
    free(t);
}

const struct source_kind source_stream = {
    open_stream,
    next,
    close_stream,
    false,
    "no complete frame has arrived: send PPM, PGM or JPEG, or set width and height for raw frames",
};

const struct source_kind source_topic = {
    open_stream, next, close_stream, false, "no image has arrived on the topic",
};
