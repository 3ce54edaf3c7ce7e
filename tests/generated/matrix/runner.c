/* Runs the program it is linked with on its recordings, and compares the results. Reads no
 * files, so that it runs on machines without a file system. Prints the differences; the exit
 * status is 1 if there are any. The last line is a hash of the state, for comparison with other
 * machines. */
#include <frob/cell.h>
#include <frob/step.h>
#include <frob/trace.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "expected.h"

extern const struct frob_program frob_program;

enum { MOST_COLUMNS = 4096 };

static const struct frob_value *columns[MOST_COLUMNS];
static int column_count;

static void add_column(void *context, const char *name, const struct frob_value *value)
{
    (void)context;
    (void)name;
    if (column_count == MOST_COLUMNS) {
        puts("too many columns");
        exit(2);
    }
    columns[column_count++] = value;
}

/* Memory filled with garbage, as a careless caller might pass it, so that reads of uninitialized
 * memory change the results. */
static void *litter(size_t size)
{
    void *memory = malloc(size + 1);
    if (memory == NULL) {
        puts("out of memory");
        exit(2);
    }
    return memset(memory, 0xa5, size + 1);
}

static uint64_t mix(uint64_t hash, const struct frob_text *text)
{
    for (size_t i = 0; i < text->length; i++)
        hash = (hash ^ (unsigned char)text->data[i]) * UINT64_C(0x100000001b3);
    return hash;
}

void mix_int(uint64_t *hash, int64_t number)
{
    for (int i = 0; i < 64; i += 8)
        *hash = (*hash ^ (((uint64_t)number >> i) & 0xff)) * UINT64_C(0x100000001b3);
}

void mix_real(uint64_t *hash, double number)
{
    int64_t bits = 0x7ff8000000000000;
    if (number == number)
        memcpy(&bits, &number, sizeof bits);
    mix_int(hash, bits);
}

static double seconds(uint64_t bits)
{
    double number;
    memcpy(&number, &bits, sizeof number);
    return number;
}

/* Moves the state to another place and fills the old one with garbage. */
static void *moved(void *state, size_t size)
{
    void *elsewhere = litter(size);
    memcpy(elsewhere, state, size);
    memset(state, 0xa5, size);
    free(state);
    return elsewhere;
}

static void read_cell(const char *cell, const struct frob_value *value, void *into)
{
    struct frob_cell_error error;
    if (!frob_cell_read(cell, value, into, NULL, &error)) {
        printf("unreadable cell: %s\n", cell);
        exit(2);
    }
}

static void *params_of(const struct recording *r)
{
    void *params = litter(frob_program.params_size);
    for (size_t i = 0; i < frob_program.param_count; i++)
        read_cell(r->params[i], frob_program.params[i].value, params);
    return params;
}

static uint64_t trace_of(const struct recording *r, uint64_t *state_hash)
{
    const struct frob_program *program = &frob_program;
    const size_t room = frob_trace_room(program, FROB_TRACE_OUT);
    char *buffer = (char *)litter(room);
    void *state = litter(program->state_size), *input = litter(program->input_size),
         *output = litter(program->output_size), *params = params_of(r);
    struct frob_text text = frob_text_in(buffer, room);
    uint64_t hash = UINT64_C(0xcbf29ce484222325);

    frob_trace_header(&text, program, FROB_TRACE_OUT);
    hash = mix(hash, &text);
    program->reset(state, params);
    for (int i = 0; i < r->count; i++) {
        const struct row *row = &r->rows[i];
        const double dt = seconds(row->dt);
        const int64_t dt_ns = i == 0 ? 0 : frob_whole_ns(dt);
        for (int k = 0; k < column_count; k++)
            read_cell(row->cells[k], columns[k], input);
        if (r->step_single != NULL)
            r->step_single(state, params, (float)dt, input, output);
        else
            program->step(state, params, dt_ns, (double)dt_ns / 1e9, input, output);
        hash_state(state_hash, state);
        if (i == r->count / 2)
            state = moved(state, program->state_size);
        frob_text_clear(&text);
        frob_trace_row(&text, program, FROB_TRACE_OUT, row->time_ns, NULL, output);
        hash = mix(hash, &text);
    }
    free(buffer);
    free(state);
    free(input);
    free(output);
    free(params);
    return hash;
}

int main(void)
{
    int differ = 0;
    uint64_t state_hash = UINT64_C(0xcbf29ce484222325);
    frob_trace_columns(frob_program.input, "in", add_column, NULL);
    for (int i = 0; i < recording_count; i++)
        if (trace_of(&recordings[i], &state_hash) != recordings[i].trace) {
            printf("%s: recording %d: the output differs\n", frob_program.name, i);
            differ = 1;
        }
    printf("state %08lx%08lx\n", (unsigned long)(state_hash >> 32),
           (unsigned long)(state_hash & 0xffffffff));
    return differ;
}
