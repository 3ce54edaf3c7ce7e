#include "record.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static bool complain(const struct record *r)
{
    fprintf(stderr, "error: cannot write %s: %s\n", r->name, strerror(errno));
    return false;
}

static bool write_text(struct record *r)
{
    size_t written = fwrite(r->text.data, 1, r->text.length, r->file);
    bool ok = written == r->text.length;
    frob_text_clear(&r->text);
    return ok || complain(r);
}

bool record_open(struct record *r, const struct frob_program *program, const char *name)
{
    size_t room;
    memset(r, 0, sizeof *r);
    if (name == NULL)
        return true;
    room = frob_trace_room(program, FROB_TRACE_IN | FROB_TRACE_OUT);
    r->program = program;
    r->name = name;
    r->file = fopen(name, "wb");
    r->buffer = (char *)malloc(room);
    if (r->file == NULL || r->buffer == NULL)
        return complain(r);
    r->text = frob_text_in(r->buffer, room);
    frob_trace_header(&r->text, program, FROB_TRACE_IN | FROB_TRACE_OUT);
    return write_text(r);
}

bool record_row(struct record *r, int64_t time_ns, const void *in, const void *out)
{
    if (r->file == NULL)
        return true;
    frob_trace_row(&r->text, r->program, FROB_TRACE_IN | FROB_TRACE_OUT, time_ns, in, out);
    return write_text(r);
}

bool record_close(struct record *r)
{
    bool ok = r->file == NULL || fclose(r->file) == 0;
    free(r->buffer);
    return ok || complain(r);
}
