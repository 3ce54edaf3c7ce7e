#include "drawing.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- Finding the drawing */

/* The probe is called `draw`, or `draw.1` in a program that has a signal called `draw`. */
static bool is_drawing(const struct frob_field *field)
{
    static const char name[] = "draw";
    const char *rest;
    if (field->name == NULL || strncmp(field->name, name, sizeof name - 1) != 0)
        return false;
    rest = field->name + sizeof name - 1;
    if (*rest == '.')
        rest += 1 + strspn(rest + 1, "0123456789");
    return *rest == '\0' && field->value->kind == FROB_ARRAY &&
           field->value->constructors[0].count > 0 &&
           field->value->constructors[0].fields[0].value->is_event;
}

/* The program without its drawing. */
static struct {
    struct frob_program program;
    struct frob_value probes;
    struct frob_constructor record;
    const struct frob_value *drawing;
} hidden;

const struct frob_value *drawing_of(const struct frob_program *program)
{
    const struct frob_constructor *probes;
    if (program == &hidden.program)
        return hidden.drawing;
    if (program->probes == NULL)
        return NULL;
    probes = &program->probes->constructors[0];
    for (size_t i = 0; i < probes->count; i++)
        if (is_drawing(&probes->fields[i]))
            return probes->fields[i].value;
    return NULL;
}

const struct frob_program *drawing_hide(const struct frob_program *program)
{
    const struct frob_constructor *record;
    struct frob_field *fields;
    hidden.drawing = drawing_of(program);
    if (hidden.drawing == NULL)
        return program;
    record = &program->probes->constructors[0];
    fields = (struct frob_field *)calloc(record->count, sizeof *fields);
    if (fields == NULL)
        return program;
    hidden.program = *program;
    hidden.probes = *program->probes;
    hidden.record = *record;
    hidden.record.count = 0;
    hidden.record.fields = fields;
    hidden.probes.constructors = &hidden.record;
    for (size_t i = 0; i < record->count; i++)
        if (record->fields[i].value != hidden.drawing)
            fields[hidden.record.count++] = record->fields[i];
    hidden.program.probes = hidden.record.count > 0 ? &hidden.probes : NULL;
    return &hidden.program;
}

size_t drawing_room(const struct frob_value *drawing)
{
    return drawing->constructors[0].count;
}

/* ---- Reading values */

/* Returns the constructor of a value in an output. */
static const struct frob_constructor *constructor_of(const struct frob_value *value,
                                                     const void *output)
{
    unsigned char tag = 0;
    if (value->kind == FROB_SUM)
        tag = ((const unsigned char *)output)[value->offset];
    return tag < value->count ? &value->constructors[tag] : NULL;
}

static double number_of(const struct frob_value *value, const void *output)
{
    const char *at = (const char *)output + value->offset;
    double number;
    float single;
    if (value->kind == FROB_SINGLE) {
        memcpy(&single, at, sizeof single);
        return (double)single;
    }
    memcpy(&number, at, sizeof number);
    return number;
}

/* Appends the numbers of a value, such as a point. */
static size_t numbers_of(const struct frob_value *value, const void *output, double *numbers,
                         size_t count, size_t most)
{
    if (value->kind == FROB_FLOAT || value->kind == FROB_SINGLE || value->kind == FROB_ROUNDED) {
        if (count < most)
            numbers[count++] = number_of(value, output);
    } else if (value->kind == FROB_PRODUCT) {
        for (size_t i = 0; i < value->constructors[0].count; i++)
            count =
                numbers_of(value->constructors[0].fields[i].value, output, numbers, count, most);
    }
    return count;
}

static void colour_of(const char *name, struct drawing_mark *mark)
{
    /* The colours that the page uses on a dark background. */
    static const struct {
        const char *name;
        unsigned char parts[3];
    } colours[] = {
        { "Red", { 0xff, 0x70, 0x43 } },    { "Orange", { 0xe6, 0x9f, 0x00 } },
        { "Yellow", { 0xf0, 0xe4, 0x42 } }, { "Green", { 0x00, 0xc0, 0x8b } },
        { "Blue", { 0x56, 0xb4, 0xe9 } },   { "Purple", { 0xe6, 0x9a, 0xc4 } },
        { "Grey", { 0x9a, 0xa3, 0xaf } },
    };
    size_t i = 0;
    while (i + 1 < sizeof colours / sizeof colours[0] && strcmp(colours[i].name, name) != 0)
        i++;
    mark->red = (float)colours[i].parts[0] / 255.0f;
    mark->green = (float)colours[i].parts[1] / 255.0f;
    mark->blue = (float)colours[i].parts[2] / 255.0f;
}

/* Copies a string from the name of its constructor, which is a quoted string with Frob's escape
 * sequences. */
static void copy_text(const char *name, char text[DRAWING_TEXT])
{
    size_t length = 0;
    if (*name == '"')
        name++;
    for (; *name != '\0' && *name != '"' && length + 1 < DRAWING_TEXT; name++) {
        char c = *name;
        if (c == '\\' && name[1] != '\0') {
            name++;
            c = *name == 'n' ? '\n' : *name == 't' ? '\t' : *name;
        }
        text[length++] = c;
    }
    /* Does not split a UTF-8 character. */
    if (length + 1 == DRAWING_TEXT)
        while (length > 0 && ((unsigned char)text[length - 1] & 0x80) != 0)
            length--;
    text[length] = '\0';
}

static bool read_shape(const struct frob_constructor *shape, const void *output,
                       struct drawing_mark *mark)
{
    static const struct {
        const char *name;
        size_t count;
    } shapes[] = { { "Line", 4 }, { "Arrow", 4 }, { "Circle", 3 },
                   { "Box", 5 },  { "Cross", 2 }, { "Label", 2 } };
    enum { SHAPES = sizeof shapes / sizeof shapes[0], MOST = sizeof mark->at / sizeof mark->at[0] };
    size_t i = 0, count = 0;
    while (i < SHAPES && strcmp(shapes[i].name, shape->name) != 0)
        i++;
    for (size_t k = 0; k < shape->count; k++)
        count = numbers_of(shape->fields[k].value, output, mark->at, count, MOST);
    if (i == SHAPES || count != shapes[i].count)
        return false;
    for (size_t k = 0; k < count; k++)
        if (!isfinite(mark->at[k]))
            return false;
    mark->shape = (enum drawing_shape)i;
    if (mark->shape == DRAWING_LABEL) {
        const struct frob_constructor *text = constructor_of(shape->fields[1].value, output);
        copy_text(text != NULL && text->name != NULL ? text->name : "", mark->text);
    }
    return true;
}

bool drawing_read(const struct frob_value *drawing, size_t i, const void *output,
                  struct drawing_mark *mark)
{
    const struct frob_value *event = drawing->constructors[0].fields[i].value;
    const struct frob_constructor *one, *colour, *shape;
    memset(mark, 0, sizeof *mark);
    if (((const unsigned char *)output)[event->offset] == 0)
        return false;
    one = constructor_of(event->constructors[1].fields[0].value, output);
    if (one == NULL || one->name == NULL || one->count != 2)
        return false;
    mark->is_on_robot = strcmp(one->name, "OnRobot") == 0;
    if (!mark->is_on_robot && strcmp(one->name, "InWorld") != 0)
        return false;
    colour = constructor_of(one->fields[0].value, output);
    shape = constructor_of(one->fields[1].value, output);
    if (colour == NULL || shape == NULL || shape->name == NULL)
        return false;
    colour_of(colour->name != NULL ? colour->name : "", mark);
    return read_shape(shape, output, mark);
}
