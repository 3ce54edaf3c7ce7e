#include "instants.h"

#include "../common/frames.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <frob/trace.h>

static const unsigned parts = FROB_TRACE_IN | FROB_TRACE_OUT;

static size_t room_of(const struct frob_program *program)
{
    return strlen(program->name) + 20 + params_room(program) + frob_trace_room(program, parts);
}

void instants_open(struct instants *i, const struct params *params, const struct line *line)
{
    const struct frob_program *program = params->program;
    const size_t most = line->opening != NULL && line->opening->publish != NULL
                            ? line->opening->publish_room(line)
                            : 0;
    const size_t room = room_of(program);
    memset(i, 0, sizeof *i);
    i->params = params;
    if (most == 0)
        return;
    if (frames_has_images(program->input) || room > most) {
        fprintf(stderr, "warning: the instants of %s are not published, because %s; use --record\n",
                program->name, room > most ? "they are too long" : "they contain images");
        return;
    }
    i->buffer = (char *)malloc(room);
    if (i->buffer != NULL)
        i->text = frob_text_in(i->buffer, room);
}

void instants_restart(struct instants *i)
{
    i->announced = false;
}

void instants_reset(struct instants *i)
{
    i->announced = false;
    i->number = 0;
}

static void publish(struct instants *i, const struct line *line, int64_t number)
{
    line->opening->publish(line, number, i->text.data, i->text.length);
    frob_text_clear(&i->text);
}

/* Publishes a line with the name of the program, followed by the beginning of a recording. */
static void announce(struct instants *i, const struct line *line)
{
    const struct frob_program *program = i->params->program;
    frob_text_add(&i->text, "# program ");
    frob_text_add(&i->text, program->name);
    frob_text_add(&i->text, "\n");
    params_head(&i->text, program, i->params->values);
    frob_trace_header(&i->text, program, parts);
    publish(i, line, -1);
    i->announced = true;
}

void instants_put(struct instants *i, const struct line *line, int64_t time_ns, void *in,
                  const void *out)
{
    if (i->buffer == NULL)
        return;
    if (line_is_open(line)) {
        if (!i->announced)
            announce(i, line);
        frob_trace_row(&i->text, i->params->program, parts, time_ns, in, out);
        publish(i, line, i->number);
    }
    i->number++;
}

void instants_close(struct instants *i)
{
    free(i->buffer);
    i->buffer = NULL;
}
