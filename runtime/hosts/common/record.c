#include "record.h"

#include "params.h"

#include <frob/camera.h>

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static bool complain(const struct record *r)
{
    fprintf(stderr, "error: cannot write %s: %s\n", r->name, strerror(errno));
    return false;
}

static bool write_text(struct record *r)
{
    const char *at = r->text.data;
    size_t left = r->text.length;
    while (left > 0) {
        ssize_t written = write(r->file, at, left);
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0)
            return complain(r);
        at += written;
        left -= (size_t)written;
    }
    frob_text_clear(&r->text);
    return true;
}

bool record_open(struct record *r, const struct frob_program *program, const void *params,
                 const char *name)
{
    size_t room;
    memset(r, 0, sizeof *r);
    r->file = -1;
    if (name == NULL)
        return true;
    room = params_room(program) + frob_trace_room(program, FROB_TRACE_IN | FROB_TRACE_OUT);
    r->program = program;
    r->name = name;
    r->file = open(name, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    r->buffer = (char *)malloc(room);
    if (r->file < 0 || r->buffer == NULL)
        return complain(r);
    if (frames_has_images(program->input) && !frame_writer_open(&r->frames, name))
        return false;
    r->text = frob_text_in(r->buffer, room);
    params_head(&r->text, program, params);
    frob_trace_header(&r->text, program, FROB_TRACE_IN | FROB_TRACE_OUT);
    return write_text(r);
}

/* In the context the writer; its folder is gone when one could not be written. */
static void put_frame(void *context, const struct frob_image **image)
{
    struct frame_writer *frames = (struct frame_writer *)context;
    if (!frame_writer_put(frames, *image))
        frame_writer_close(frames);
}

/* False if one cannot be written; no other is then. */
static bool put_frames(struct record *r, void *in)
{
    if (r->frames.folder == NULL)
        return true;
    frob_camera_images(r->program->input, in, put_frame, &r->frames);
    return r->frames.folder != NULL;
}

bool record_row(struct record *r, int64_t time_ns, void *in, const void *out)
{
    if (r->file < 0)
        return true;
    if (!put_frames(r, in))
        return false;
    frob_trace_row(&r->text, r->program, FROB_TRACE_IN | FROB_TRACE_OUT, time_ns, in, out);
    return write_text(r);
}

bool record_close(struct record *r)
{
    bool ok = r->file < 0 || close(r->file) == 0;
    free(r->buffer);
    frame_writer_close(&r->frames);
    return ok || complain(r);
}
