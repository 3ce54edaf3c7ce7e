#include <frob/cell.h>
#include <frob/trace.h>

#include <stdio.h>
#include <string.h>

/* Maximum length of a column's path. A longer path is truncated, so the column is not found when
 * the trace is read; the reader reports that. */
#define PATH_ROOM 1024

static bool has_columns_inside(const struct frob_value *value)
{
    const struct frob_constructor *product;
    if (value->kind == FROB_ARRAY)
        return true;
    if (value->kind != FROB_PRODUCT)
        return false;
    product = &value->constructors[0];
    /* The parts of arrays, tuples and records are in separate columns. A value of any other type is
     * in a single cell, even if the type has only one constructor. */
    return product->name == NULL || product->is_record;
}

static void visit_columns(const struct frob_value *value, struct frob_text *path,
                          frob_column_visitor *visit, void *context)
{
    const struct frob_constructor *product;
    size_t length = path->length;
    if (!has_columns_inside(value)) {
        visit(context, path->data, value);
        return;
    }
    product = &value->constructors[0];
    for (size_t i = 0; i < product->count; i++) {
        char number[24];
        bool array = value->kind == FROB_ARRAY;
        snprintf(number, sizeof number, array ? "[%lu]" : "%lu",
                 array ? (unsigned long)i : (unsigned long)i + 1);
        if (!array)
            frob_text_add_char(path, '.');
        frob_text_add(path, product->name == NULL ? number : product->fields[i].name);
        visit_columns(product->fields[i].value, path, visit, context);
        frob_text_cut(path, length);
    }
}

void frob_trace_columns(const struct frob_value *value, const char *root,
                        frob_column_visitor *visit, void *context)
{
    char buffer[PATH_ROOM];
    struct frob_text path = frob_text_in(buffer, sizeof buffer);
    frob_text_add(&path, root);
    visit_columns(value, &path, visit, context);
}

/* Adds a name. Quotes it if it contains a comma or a quote, as an assertion's label may. */
static void add_name(void *context, const char *name, const struct frob_value *value)
{
    struct frob_text *text = (struct frob_text *)context;
    const bool quoted = strpbrk(name, ",\"") != NULL;
    (void)value;
    frob_text_add_char(text, ',');
    if (quoted)
        frob_text_add_char(text, '"');
    for (const char *c = name; *c != '\0'; c++) {
        if (*c == '"')
            frob_text_add_char(text, '"');
        frob_text_add_char(text, *c);
    }
    if (quoted)
        frob_text_add_char(text, '"');
}

void frob_trace_header(struct frob_text *text, const struct frob_program *program, unsigned parts)
{
    frob_text_add(text, "time");
    if ((parts & FROB_TRACE_IN) != 0)
        frob_trace_columns(program->input, "in", add_name, text);
    if ((parts & FROB_TRACE_OUT) != 0)
        frob_trace_columns(program->output, "out", add_name, text);
    if ((parts & FROB_TRACE_OUT) != 0 && program->probes != NULL)
        frob_trace_columns(program->probes, "probe", add_name, text);
    if ((parts & FROB_TRACE_MODES) != 0) {
        for (size_t i = 0; i < program->machine_count; i++) {
            frob_text_add(text, ",mode.");
            frob_text_add(text, program->machines[i].name);
        }
    }
    frob_text_add_char(text, '\n');
}

struct row {
    struct frob_text *text;
    const void *base;
};

/* Doubles each quote from `start` on. */
static void double_quotes(struct frob_text *text, size_t start)
{
    size_t count = 0, from = text->length;
    for (size_t i = start; i < text->length; i++)
        count += text->data[i] == '"' ? 1 : 0;
    for (size_t i = 0; i < count; i++)
        frob_text_add_char(text, '"');
    for (size_t to = text->length; from > start && to > from;) {
        const char c = text->data[--from];
        text->data[--to] = c;
        if (c == '"' && to > from)
            text->data[--to] = c;
    }
}

/* Cells do not contain line feeds, so a cell must be quoted only if it contains a comma or, in a
 * label, a quotation mark. */
static void add_cell(void *context, const char *name, const struct frob_value *value)
{
    struct row *row = (struct row *)context;
    struct frob_text *text = row->text;
    size_t start;
    (void)name;
    frob_text_add_char(text, ',');
    start = text->length;
    frob_cell_write(text, value, row->base);
    if (strpbrk(text->data + start, ",\"") != NULL) {
        frob_text_cut(text, start);
        frob_text_add_char(text, '"');
        frob_cell_write(text, value, row->base);
        double_quotes(text, start + 1);
        frob_text_add_char(text, '"');
    }
}

int32_t frob_trace_mode(const struct frob_program *program, size_t i, const void *state)
{
    const struct frob_machine *machine = &program->machines[i];
    const unsigned char *place = (const unsigned char *)state + machine->offset;
    int32_t number;
    if (machine->within > 0 &&
        frob_trace_mode(program, machine->within - 1, state) != machine->mode)
        return -1;
    if (machine->size == 1)
        return *place;
    memcpy(&number, place, sizeof number);
    return number;
}

static void add_columns(struct frob_text *text, const struct frob_program *program, unsigned parts,
                        int64_t time_ns, const void *in, const void *out)
{
    char stamp[40];
    uint64_t ns = time_ns < 0 ? 0u - (uint64_t)time_ns : (uint64_t)time_ns;
    struct row row = { text, in };
    snprintf(stamp, sizeof stamp, "%s%llu.%09llu", time_ns < 0 ? "-" : "",
             (unsigned long long)(ns / 1000000000u), (unsigned long long)(ns % 1000000000u));
    frob_text_add(text, stamp);
    if ((parts & FROB_TRACE_IN) != 0)
        frob_trace_columns(program->input, "in", add_cell, &row);
    row.base = out;
    if ((parts & FROB_TRACE_OUT) != 0)
        frob_trace_columns(program->output, "out", add_cell, &row);
    if ((parts & FROB_TRACE_OUT) != 0 && program->probes != NULL)
        frob_trace_columns(program->probes, "probe", add_cell, &row);
}

void frob_trace_row(struct frob_text *text, const struct frob_program *program, unsigned parts,
                    int64_t time_ns, const void *in, const void *out)
{
    add_columns(text, program, parts, time_ns, in, out);
    frob_text_add_char(text, '\n');
}

void frob_trace_row_with_modes(struct frob_text *text, const struct frob_program *program,
                               unsigned parts, int64_t time_ns, const void *in, const void *out,
                               const void *state)
{
    add_columns(text, program, parts, time_ns, in, out);
    for (size_t i = 0; i < program->machine_count; i++) {
        int32_t number = frob_trace_mode(program, i, state);
        frob_text_add_char(text, ',');
        if (number >= 0 && (size_t)number < program->machines[i].count)
            frob_text_add(text, program->machines[i].modes[number]);
    }
    frob_text_add_char(text, '\n');
}

static void add_room(void *context, const char *name, const struct frob_value *value)
{
    size_t *room = (size_t *)context;
    size_t cell = frob_cell_room(value);
    size_t heading = 2 * strlen(name);
    *room += (2 * cell > heading ? 2 * cell : heading) + 4;
}

size_t frob_trace_room(const struct frob_program *program, unsigned parts)
{
    size_t room = 64;
    if ((parts & FROB_TRACE_IN) != 0)
        frob_trace_columns(program->input, "in", add_room, &room);
    if ((parts & FROB_TRACE_OUT) != 0)
        frob_trace_columns(program->output, "out", add_room, &room);
    if ((parts & FROB_TRACE_OUT) != 0 && program->probes != NULL)
        frob_trace_columns(program->probes, "probe", add_room, &room);
    if ((parts & FROB_TRACE_MODES) != 0) {
        for (size_t i = 0; i < program->machine_count; i++) {
            const struct frob_machine *machine = &program->machines[i];
            size_t longest = strlen(machine->name) + strlen("mode.");
            for (size_t k = 0; k < machine->count; k++)
                if (strlen(machine->modes[k]) > longest)
                    longest = strlen(machine->modes[k]);
            room += longest + 1;
        }
    }
    return room;
}
