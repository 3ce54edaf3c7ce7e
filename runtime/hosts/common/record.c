#include "record.h"

#include "params.h"

#include <frob/camera.h>

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool complain(const struct record *r)
{
    fprintf(stderr, "error: cannot write %s: %s\n", r->name, packed_reason(r->name, errno));
    return false;
}

static bool write_text(struct record *r)
{
    if (!packer_put(&r->file, r->text.data, r->text.length))
        return complain(r);
    frob_text_clear(&r->text);
    return true;
}

bool record_open(struct record *r, const struct frob_program *program, const void *params,
                 const char *name)
{
    size_t room;
    memset(r, 0, sizeof *r);
    r->file.file = -1;
    if (name == NULL)
        return true;
    room = params_room(program) + frob_trace_room(program, FROB_TRACE_IN | FROB_TRACE_OUT);
    r->program = program;
    r->name = name;
    r->buffer = (char *)malloc(room);
    if (!packer_open(&r->file, name) || r->buffer == NULL)
        return complain(r);
    if (frames_has_images(program->input) && !frame_writer_open(&r->frames, name))
        return false;
    r->text = frob_text_in(r->buffer, room);
    params_head(&r->text, program, params);
    frob_trace_header(&r->text, program, FROB_TRACE_IN | FROB_TRACE_OUT);
    return write_text(r);
}

/* Writes a frame; `context` is the frame writer. On failure, closes the writer, which sets the
 * writer's folder to NULL. */
static void put_frame(void *context, const struct frob_image **image)
{
    struct frame_writer *frames = (struct frame_writer *)context;
    if (!frame_writer_put(frames, *image))
        frame_writer_close(frames);
}

/* Writes the frames of an input. If one cannot be written, returns false, and writes no more
 * frames. */
static bool put_frames(struct record *r, void *in)
{
    if (r->frames.folder == NULL)
        return true;
    frob_camera_images(r->program->input, in, put_frame, &r->frames);
    return r->frames.folder != NULL;
}

bool record_row(struct record *r, int64_t time_ns, void *in, const void *out)
{
    if (r->file.file < 0)
        return true;
    if (!put_frames(r, in))
        return false;
    frob_trace_row(&r->text, r->program, FROB_TRACE_IN | FROB_TRACE_OUT, time_ns, in, out);
    return write_text(r);
}

void record_report_interruption(const char *name, double time_s)
{
    fprintf(stderr, "interrupted at %.3f s: the summary covers the run until then", time_s);
    if (name != NULL)
        fprintf(stderr, ", and so does %s", name);
    fprintf(stderr, "; run the same command again to start over%s\n",
            name != NULL ? " and overwrite that file" : "");
}

bool record_close(struct record *r)
{
    const bool ok = packer_close(&r->file) || complain(r);
    free(r->buffer);
    frame_writer_close(&r->frames);
    return ok;
}
