/* runner.c -- the main function of each program of the self-test. It runs the program with recorded
 * input, and compares the output with the expected rows of a trace. The last line on standard
 * output is `right` if everything matches, and otherwise describes the first difference. */
#include <frob/cell.h>
#include <frob/program.h>
#include <frob/trace.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "recording.h"

#ifdef __cplusplus
extern "C" {
#endif
extern const struct frob_program frob_program;
#ifdef __cplusplus
}
#endif

enum { MOST_COLUMNS = 64 };

static const struct frob_value *columns[MOST_COLUMNS];
static int column_count;

static void add_column(void *context, const char *name, const struct frob_value *value)
{
    (void)context;
    (void)name;
    if (column_count < MOST_COLUMNS)
        columns[column_count++] = value;
}

/* Allocates memory filled with garbage, so that reading an uninitialized field has a visible
   effect. */
static void *litter(size_t size)
{
    void *memory = malloc(size + 1);
    if (memory == NULL) {
        puts("no memory");
        exit(1);
    }
    return memset(memory, 0xa5, size + 1);
}

/* The length of a cell. A quoted cell may contain commas. */
static int cell_length(const char *cell)
{
    int length = 0, quoted = 0;
    while (cell[length] != '\0' && cell[length] != '\n' && (quoted || cell[length] != ',')) {
        if (cell[length] == '"')
            quoted = !quoted;
        length++;
    }
    return length;
}

/* Prints the first cell that differs. `names` is the header of the trace. */
static void complain(int step, const char *names, const char *found, const char *expected)
{
    for (;;) {
        const int name = cell_length(names), a = cell_length(found), b = cell_length(expected);
        if (a != b || strncmp(found, expected, (size_t)a) != 0 || found[a] != ',') {
            printf("step %d: %.*s is %.*s but must be %.*s\n", step, name, names, a, found, b,
                   expected);
            return;
        }
        names += name + 1;
        found += a + 1;
        expected += b + 1;
    }
}

static int is_right(void *state, void *input, void *output, const char *names,
                    struct frob_text *text)
{
    int64_t before = 0;
    frob_program.reset(state, NULL);
    for (int i = 0; i < recorded_row_count; i++) {
        const struct recorded_row *row = &recorded_rows[i];
        for (int k = 0; k < column_count; k++) {
            struct frob_cell_error error;
            if (!frob_cell_read(row->cells[k], columns[k], input, NULL, &error)) {
                printf("cannot read the cell `%s`\n", row->cells[k]);
                return 0;
            }
        }
        const int64_t dt_ns = i == 0 ? 0 : row->time_ns - before;
        frob_program.step(state, NULL, dt_ns, (double)dt_ns / 1e9, input, output);
        before = row->time_ns;
        frob_text_clear(text);
        frob_trace_row(text, &frob_program, FROB_TRACE_OUT, row->time_ns, NULL, output);
        if (strcmp(text->data, row->output) != 0) {
            complain(i + 1, names, text->data, row->output);
            return 0;
        }
    }
    return 1;
}

int main(void)
{
    const size_t room = frob_trace_room(&frob_program, FROB_TRACE_OUT);
    void *state = litter(frob_program.state_size), *input = litter(frob_program.input_size);
    void *output = litter(frob_program.output_size);
    char *line = (char *)litter(room);
    char *names = (char *)litter(room);
    struct frob_text text = frob_text_in(line, room), header = frob_text_in(names, room);
    int right;
    frob_trace_header(&header, &frob_program, FROB_TRACE_OUT);
    frob_trace_columns(frob_program.input, "in", add_column, NULL);
    /* The second run starts with a reset, which must clear all state. */
    right = is_right(state, input, output, names, &text) &&
            is_right(state, input, output, names, &text);
    if (right)
        puts("right");
    free(state);
    free(input);
    free(output);
    free(line);
    free(names);
    return right ? 0 : 1;
}
