/* Reads a folder of images in the order of their names, at a fixed rate. */
#include "decode.h"
#include "source.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

struct folder {
    struct dirent **names;
    int count, next, good;
    int64_t due_ns;
};

static int is_picture(const struct dirent *entry)
{
    static const char *const ends[] = { ".ppm", ".pgm", ".jpg", ".jpeg" };
    const char *dot = strrchr(entry->d_name, '.');
    for (size_t i = 0; dot != NULL && dot != entry->d_name && i < sizeof ends / sizeof ends[0]; i++)
        if (strcmp(dot, ends[i]) == 0)
            return 1;
    return 0;
}

static bool open_folder(struct source *s)
{
    struct folder *f = (struct folder *)calloc(1, sizeof *f);
    if (f == NULL ||
        (f->count = scandir(s->options->source, &f->names, is_picture, alphasort)) < 0) {
        source_fail(s, SOURCE_FAULT, "the folder cannot be read: %s", strerror(errno));
        free(f);
        return false;
    }
    if (f->count == 0) {
        free(f->names);
        free(f);
        source_fail(s, SOURCE_FAULT,
                    "there is no picture in the folder: add .ppm, .pgm or .jpg files, which are "
                    "shown in the order of their names");
        return false;
    }
    s->is_recorded = true;
    s->state = f;
    snprintf(s->what, sizeof s->what, "%d pictures at %g Hz", f->count,
             s->options->settings[CAMERA_RATE]);
    return true;
}

/* Reads a whole file into memory that the caller frees. Returns NULL with errno set on failure. */
static uint8_t *read_file(const struct source *s, const char *name, size_t *size)
{
    const int folder = open(s->options->source, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const int file = folder < 0 ? -1 : openat(folder, name, O_RDONLY | O_CLOEXEC);
    struct stat status;
    uint8_t *bytes = NULL;
    *size = 0;
    if (file >= 0 && fstat(file, &status) == 0) {
        if (S_ISREG(status.st_mode) && status.st_size <= (off_t)(2 * BUFFERS_ROOM))
            bytes = (uint8_t *)malloc((size_t)status.st_size + 1);
        else
            errno = EFBIG;
        while (bytes != NULL && *size < (size_t)status.st_size) {
            const ssize_t got = read(file, bytes + *size, (size_t)status.st_size - *size);
            if (got <= 0)
                break;
            *size += (size_t)got;
        }
    }
    if (file >= 0)
        close(file);
    if (folder >= 0)
        close(folder);
    return bytes;
}

static enum source_result next(struct source *s, struct captured *frame, int wait_ms)
{
    struct folder *f = (struct folder *)s->state;
    const int64_t now = source_now_ns();
    const char *name, *fault;
    char message[256], last[sizeof s->fault];
    uint8_t *bytes;
    size_t size;
    if (f->next == f->count && f->good > 0)
        return source_fail(s, SOURCE_OVER, "all %d pictures have been shown", f->count);
    if (f->next == f->count) {
        snprintf(last, sizeof last, "%s", s->fault);
        return source_fail(s, SOURCE_OVER,
                           "no picture in the folder could be read; the last error: %s", last);
    }
    if (f->due_ns > now + wait_ms * INT64_C(1000000)) {
        source_sleep_until_ns(now + wait_ms * INT64_C(1000000));
        return SOURCE_NOTHING;
    }
    if (f->next == 0)
        f->due_ns = now;
    source_sleep_until_ns(f->due_ns);
    f->due_ns += (int64_t)(1e9 / s->options->settings[CAMERA_RATE]);
    name = f->names[f->next++]->d_name;
    frame->captured_ns = source_now_ns();
    bytes = read_file(s, name, &size);
    if (bytes == NULL)
        return source_fail(s, SOURCE_BROKEN, "%s cannot be read: %s", name, strerror(errno));
    fault = decode_picture(bytes, size, s->options->settings[CAMERA_GREY] > 0.0, frame, message);
    free(bytes);
    f->good += fault == NULL;
    return fault == NULL ? SOURCE_FRAME : source_fail(s, SOURCE_BROKEN, "%s (%s)", fault, name);
}

static void close_folder(struct source *s)
{
    struct folder *f = (struct folder *)s->state;
    for (int i = 0; i < f->count; i++)
        free(f->names[i]);
    free(f->names);
    free(f);
}

const struct source_kind source_folder = {
    open_folder, next, close_folder, false,
    "its pictures are too far apart in time: increase its rate"
};
