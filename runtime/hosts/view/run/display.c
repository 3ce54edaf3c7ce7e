#include "display.h"

#include <stdlib.h>
#include <string.h>

static int constructor_of(const struct frob_value *mark, const char *name)
{
    for (size_t i = 0; i < mark->count; i++)
        if (strcmp(mark->constructors[i].name, name) == 0)
            return (int)i;
    return -1;
}

/* Returns whether a signal is part of the probe `draw`, or of `draw.N` if the program defines its
 * own `draw`. */
static bool is_drawn(const struct signal *signal)
{
    static const char name[] = "probe.draw";
    const char *rest = signal->name + sizeof name - 1;
    if (signal->side != PROBE || strncmp(signal->name, name, sizeof name - 1) != 0)
        return false;
    if (*rest == '.')
        rest += 1 + strspn(rest + 1, "0123456789");
    return *rest == '[' && signal->value->kind == FROB_SUM && signal->value->is_event &&
           signal->value->constructors[1].fields[0].value->kind == FROB_SUM;
}

bool display_start(struct display *display, const struct signals *signals)
{
    const struct shown nothing = { NO_INSTANT, 0, NO_INSTANT };
    memset(display, 0, sizeof *display);
    display->picture = display->in_image = -1;
    display->size = signals->program->output_size;
    display->drawn = (struct drawn *)calloc(signals->count + 1, sizeof *display->drawn);
    display->output = (unsigned char *)malloc(display->size + 1);
    display->shown = nothing;
    display->output_of = NO_INSTANT;
    if (display->drawn == NULL || display->output == NULL)
        return false;
    for (size_t i = 0; i < signals->count; i++) {
        const struct signal *signal = &signals->all[i];
        if (!is_drawn(signal))
            continue;
        display->drawn[display->count].signal = signal;
        display->drawn[display->count].mark = signal->value->constructors[1].fields[0].value;
        display->count++;
    }
    if (display->count > 0) {
        display->picture = constructor_of(display->drawn[0].mark, "Picture");
        display->in_image = constructor_of(display->drawn[0].mark, "InImage");
    }
    return true;
}

void display_end(struct display *display)
{
    free(display->drawn);
    free(display->output);
}

/* Returns the constructor of a mark; -1 if there is no mark. */
static int mark_at(const struct drawn *drawn, const void *output)
{
    const unsigned char *bytes = (const unsigned char *)output;
    return bytes[drawn->signal->value->offset] == 0 ? -1 : bytes[drawn->mark->offset];
}

bool display_is_mark(const struct display *display, size_t element, const void *output)
{
    const int mark = mark_at(&display->drawn[element], output);
    return mark >= 0 && mark == display->in_image;
}

void display_see(struct display *display, size_t k, const void *output)
{
    bool has_marks = false;
    for (size_t i = 0; i < display->count; i++) {
        const struct drawn *drawn = &display->drawn[i];
        const int mark = mark_at(drawn, output);
        if (mark < 0 || (mark != display->picture && mark != display->in_image))
            continue;
        has_marks = true;
        if (mark == display->picture) {
            const struct frob_value *key = drawn->mark->constructors[mark].fields[0].value;
            display->shown.image = k;
            memcpy(&display->shown.key, (const unsigned char *)output + key->offset,
                   sizeof display->shown.key);
        }
    }
    if (!has_marks)
        return;
    display->shown.marks = k;
    memcpy(display->output, output, display->size);
    display->output_of = k;
}
