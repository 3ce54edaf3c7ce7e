#include "signals.h"

#include <frob/cell.h>
#include <frob/trace.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void add(struct signals *signals, const char *name, struct signal signal)
{
    if (signals->count == signals->capacity) {
        size_t capacity = signals->capacity == 0 ? 32 : signals->capacity * 2;
        struct signal *all =
            (struct signal *)realloc(signals->all, capacity * sizeof *signals->all);
        if (all == NULL) {
            signals->no_memory = true;
            return;
        }
        signals->all = all;
        signals->capacity = capacity;
    }
    signal.name = (char *)malloc(strlen(name) + 1);
    if (signal.name == NULL) {
        signals->no_memory = true;
        return;
    }
    strcpy(signal.name, name);
    signal.shown = signal.value;
    signals->all[signals->count++] = signal;
}

static void add_input(void *context, const char *name, const struct frob_value *value)
{
    add((struct signals *)context, name, (struct signal){ .side = INPUT, .value = value });
}

static void add_output(void *context, const char *name, const struct frob_value *value)
{
    add((struct signals *)context, name, (struct signal){ .side = OUTPUT, .value = value });
}

static void add_probe(void *context, const char *name, const struct frob_value *value)
{
    add((struct signals *)context, name, (struct signal){ .side = PROBE, .value = value });
}

static void add_modes(struct signals *signals)
{
    const struct frob_program *program = signals->program;
    for (size_t i = 0; i < program->machine_count; i++) {
        struct buffer name = { 0 };
        buffer_format(&name, "mode.%s", program->machines[i].name);
        if (name.data == NULL)
            signals->no_memory = true;
        else
            add(signals, name.data, (struct signal){ .side = MODE, .machine = i });
        buffer_free(&name);
    }
}

/* Finds the most specific row of the table for a signal. */
static void look_up(struct signal *signal, const struct frob_column *columns)
{
    size_t longest = 0;
    signal->below = "";
    for (const struct frob_column *column = columns; column->name != NULL; column++) {
        const size_t length = strlen(column->name);
        const char *below = signal->name + length;
        if (length > longest && strncmp(signal->name, column->name, length) == 0 &&
            (*below == '\0' || *below == '.' || *below == '[')) {
            longest = length;
            signal->column = column;
            signal->below = below;
        }
    }
    if (signal->side == PROBE && signal->value->is_event && signal->column != NULL &&
        !signal->column->is_event)
        signal->shown = signal->value->constructors[1].fields[0].value;
}

bool signals_start(struct signals *signals, const struct frob_program *program,
                   const struct frob_column *columns)
{
    memset(signals, 0, sizeof *signals);
    signals->program = program;
    frob_trace_columns(program->input, "in", add_input, signals);
    frob_trace_columns(program->output, "out", add_output, signals);
    if (program->probes != NULL)
        frob_trace_columns(program->probes, "probe", add_probe, signals);
    add_modes(signals);
    for (size_t i = 0; columns != NULL && i < signals->count; i++)
        look_up(&signals->all[i], columns);
    return !signals->no_memory;
}

void signals_end(struct signals *signals)
{
    for (size_t i = 0; i < signals->count; i++)
        free(signals->all[i].name);
    free(signals->all);
}

/* Extends the range *first … *last to include the offsets of a value's numbers, truth values and
 * tags. */
static void add_extent(const struct frob_value *value, size_t *first, size_t *last)
{
    if (value->kind != FROB_PRODUCT && value->kind != FROB_ARRAY) {
        *first = value->offset < *first ? value->offset : *first;
        *last = value->offset > *last ? value->offset : *last;
    }
    for (size_t i = 0; i < value->count; i++)
        for (size_t k = 0; k < value->constructors[i].count; k++)
            add_extent(value->constructors[i].fields[k].value, first, last);
}

size_t signals_output_size(const struct signals *signals)
{
    const struct frob_program *program = signals->program;
    size_t first = program->output_size, last = 0, ignored = 0;
    if (program->probes != NULL)
        add_extent(program->probes, &first, &ignored);
    ignored = 0;
    add_extent(program->output, &ignored, &last);
    return last < first ? first : program->output_size;
}

const struct signal *signals_find(const struct signals *signals, const char *name)
{
    for (size_t i = 0; i < signals->count; i++)
        if (strcmp(signals->all[i].name, name) == 0)
            return &signals->all[i];
    return NULL;
}

bool signal_is_mode(const struct signal *signal)
{
    return signal->side == MODE ||
           (signal->side == PROBE && signal->column != NULL &&
            strncmp(signal->column->own, "mode", 4) == 0 && signal->shown->kind == FROB_SUM);
}

static const void *base(const struct signal *signal, const struct moment *moment)
{
    return signal->side == INPUT ? moment->input : moment->output;
}

static bool is_unknown(const struct signal *signal, const struct moment *moment)
{
    return (signal->side == PROBE || signal->side == MODE) && moment->state == NULL;
}

void signal_write(const struct signals *signals, const struct signal *signal,
                  const struct moment *moment, struct buffer *text)
{
    if (is_unknown(signal, moment))
        return;
    if (signal->side == MODE) {
        const struct frob_machine *machine = &signals->program->machines[signal->machine];
        int32_t mode = frob_trace_mode(signals->program, signal->machine, moment->state);
        if (mode >= 0 && (size_t)mode < machine->count)
            buffer_text(text, machine->modes[mode]);
        return;
    }
    const size_t room = frob_cell_room(signal->value) + 1;
    char *cell = (char *)malloc(room);
    struct frob_text written;
    if (cell == NULL) {
        text->failed = true;
        return;
    }
    written = frob_text_in(cell, room);
    frob_cell_write(&written, signal->value, base(signal, moment));
    buffer_bytes(text, written.data, written.length);
    free(cell);
}

static double number_at(const struct frob_value *value, const char *bytes)
{
    const char *place = bytes + value->offset;
    const struct frob_constructor *product;
    int32_t integer;
    double real;
    float single;
    switch (value->kind) {
    case FROB_BOOL: return *(const unsigned char *)place != 0 ? 1 : 0;
    case FROB_INT: memcpy(&integer, place, sizeof integer); return integer;
    case FROB_FLOAT:
    case FROB_ROUNDED: memcpy(&real, place, sizeof real); return real;
    case FROB_SINGLE: memcpy(&single, place, sizeof single); return (double)single;
    case FROB_SUM:
        if (!value->is_event)
            return *(const unsigned char *)place;
        if (*(const unsigned char *)place == 0)
            return NAN;
        return number_at(value->constructors[1].fields[0].value, bytes);
    case FROB_PRODUCT:
    case FROB_ARRAY:
        product = &value->constructors[0];
        return product->count > 0 ? number_at(product->fields[0].value, bytes) : 1;
    case FROB_IMAGE: break;
    }
    return NAN;
}

double signal_number(const struct signals *signals, const struct signal *signal,
                     const struct moment *moment)
{
    if (is_unknown(signal, moment))
        return NAN;
    if (signal->side == MODE) {
        int32_t mode = frob_trace_mode(signals->program, signal->machine, moment->state);
        return mode < 0 ? (double)NAN : (double)mode;
    }
    return number_at(signal->value, (const char *)base(signal, moment));
}

static bool parts_equal(const struct frob_constructor *parts, const void *a, const void *b)
{
    for (size_t i = 0; i < parts->count; i++)
        if (!signal_values_equal(parts->fields[i].value, a, b))
            return false;
    return true;
}

bool signal_values_equal(const struct frob_value *value, const void *a, const void *b)
{
    const char *at = (const char *)a + value->offset, *bt = (const char *)b + value->offset;
    double x, y;
    switch (value->kind) {
    case FROB_BOOL: return *at == *bt;
    case FROB_INT: return memcmp(at, bt, sizeof(int32_t)) == 0;
    case FROB_FLOAT:
    case FROB_ROUNDED:
    case FROB_SINGLE:
        x = number_at(value, (const char *)a);
        y = number_at(value, (const char *)b);
        /* In a trace, all NaNs look the same. */
        return (isnan(x) && isnan(y)) || memcmp(&x, &y, sizeof x) == 0;
    case FROB_SUM:
        return *at == *bt && parts_equal(&value->constructors[*(const unsigned char *)at], a, b);
    case FROB_PRODUCT:
    case FROB_ARRAY: return parts_equal(&value->constructors[0], a, b);
    case FROB_IMAGE: return memcmp(at, bt, sizeof(const struct frob_image *)) == 0;
    }
    return false;
}
