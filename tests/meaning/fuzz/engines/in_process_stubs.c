/* Compiles generated C with libtcc into this process, and runs it there.
 *
 * A program that crashes or does not terminate must not end the fuzzer. While it runs, the
 * signals for this jump back here. Nothing is allocated on the OCaml heap meanwhile, so the jump
 * leaks only plain memory. */
#define _XOPEN_SOURCE 700
#include <frob/cell.h>
#include <frob/elementary.h>
#include <frob/step.h>
#include <frob/trace.h>

#include <libtcc.h>

#include "frames_stubs.h"

#include <setjmp.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define CAML_NAME_SPACE
#include <caml/alloc.h>
#include <caml/custom.h>
#include <caml/fail.h>
#include <caml/memory.h>
#include <caml/mlvalues.h>

/* Longest time for one recording, in seconds. */
enum { PATIENCE = 10 };

struct in_process {
    TCCState *compiler;
    const struct frob_program *program;
};

static struct in_process *of_value(value v)
{
    return (struct in_process *)Data_custom_val(v);
}

static void finalize(value v)
{
    if (of_value(v)->compiler != NULL)
        tcc_delete(of_value(v)->compiler);
}

static struct custom_operations operations = {
    "frob.fuzz.in_process",     finalize,
    custom_compare_default,     custom_hash_default,
    custom_serialize_default,   custom_deserialize_default,
    custom_compare_ext_default, custom_fixed_length_default,
};

struct messages {
    char text[4096];
    size_t length;
};

static void add_message(void *context, const char *message)
{
    struct messages *all = (struct messages *)context;
    size_t length = strlen(message);
    if (length + 2 > sizeof all->text - all->length)
        return;
    memcpy(all->text + all->length, message, length);
    all->length += length;
    all->text[all->length++] = '\n';
    all->text[all->length] = '\0';
}

/* Adds the runtime's elementary functions, the same ones that the interpreter calls. */
static void add_elementary(TCCState *compiler)
{
#define ONE(name) tcc_add_symbol(compiler, #name, (const void *)(intptr_t)name)
#define ADD(name)     \
    do {              \
        ONE(name);    \
        ONE(name##f); \
    } while (0)
    ADD(frob_exp);
    ADD(frob_log);
    ADD(frob_pow);
    ADD(frob_sin);
    ADD(frob_cos);
    ADD(frob_tan);
    ADD(frob_asin);
    ADD(frob_acos);
    ADD(frob_atan);
    ADD(frob_atan2);
    ADD(frob_hypot);
#undef ADD
#undef ONE
}

/* in_process_compile : string array -> string array -> t -- takes include folders and files;
 * raises Failure with the compiler's message. */
value in_process_compile(value folders, value files)
{
    CAMLparam2(folders, files);
    CAMLlocal1(result);
    struct messages messages = { "", 0 };
    TCCState *compiler = tcc_new();
    bool ok;
    if (compiler == NULL)
        caml_failwith("tcc does not start");
    tcc_set_error_func(compiler, &messages, add_message);
    tcc_set_options(compiler, "-std=c99");
    tcc_set_output_type(compiler, TCC_OUTPUT_MEMORY);
    for (mlsize_t i = 0; i < Wosize_val(folders); i++)
        tcc_add_include_path(compiler, String_val(Field(folders, i)));
    add_elementary(compiler);
    frames_add_kernels(compiler);
    ok = tcc_add_library(compiler, "m") == 0;
    for (mlsize_t i = 0; ok && i < Wosize_val(files); i++)
        ok = tcc_add_file(compiler, String_val(Field(files, i))) == 0;
    if (ok)
        ok = tcc_relocate(compiler, TCC_RELOCATE_AUTO) >= 0;
    if (!ok) {
        tcc_delete(compiler);
        caml_failwith(messages.text);
    }
    result = caml_alloc_custom(&operations, sizeof(struct in_process), 0, 1);
    of_value(result)->compiler = compiler;
    of_value(result)->program =
        (const struct frob_program *)tcc_get_symbol(compiler, FROB_PROGRAM_SYMBOL);
    if (of_value(result)->program == NULL)
        caml_failwith("the table of the program is not found");
    CAMLreturn(result);
}

value in_process_release(value v)
{
    tcc_delete(of_value(v)->compiler);
    of_value(v)->compiler = NULL;
    of_value(v)->program = NULL;
    return Val_unit;
}

static const int signals[] = { SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGALRM };
enum { SIGNALS = sizeof signals / sizeof signals[0] };

static sigjmp_buf back;

static void return_from(int signal)
{
    siglongjmp(back, signal);
}

struct columns {
    const struct frob_value **values;
    size_t count;
};

static void add_column(void *context, const char *name, const struct frob_value *value)
{
    struct columns *columns = (struct columns *)context;
    (void)name;
    columns->values = (const struct frob_value **)realloc(
        columns->values, (columns->count + 1) * sizeof *columns->values);
    if (columns->values == NULL)
        abort();
    columns->values[columns->count++] = value;
}

/* How to call a program's step: through the table for hosts, or NAME_step with its own rounding. */
struct stepper {
    const struct frob_program *program;
    const void *params;
    bool is_single; /* dt is rounded as a float */
    bool in_table;
    const void *seconds; /* NAME_step */
};

static void step_in_doubles(const struct stepper *s, void *state, double dt, const void *input,
                            void *output)
{
    void (*step)(void *, double, const void *, void *);
    void (*step_set)(void *, const void *, double, const void *, void *);
    if (s->program->param_count > 0) {
        memcpy(&step_set, &s->seconds, sizeof step_set);
        step_set(state, s->params, dt, input, output);
    } else {
        memcpy(&step, &s->seconds, sizeof step);
        step(state, dt, input, output);
    }
}

static void step_in_floats(const struct stepper *s, void *state, float dt, const void *input,
                           void *output)
{
    void (*step)(void *, float, const void *, void *);
    void (*step_set)(void *, const void *, float, const void *, void *);
    if (s->program->param_count > 0) {
        memcpy(&step_set, &s->seconds, sizeof step_set);
        step_set(state, s->params, dt, input, output);
    } else {
        memcpy(&step, &s->seconds, sizeof step);
        step(state, dt, input, output);
    }
}

/* Calls the step in the table. It must limit a dt that is out of range, so it gets such a dt as it
 * is. */
static void step_in_table(const struct stepper *s, void *state, bool is_first, double dt,
                          const void *input, void *output)
{
    const int64_t rounded = s->is_single ? frob_whole_nsf((float)dt) : frob_whole_ns(dt);
    int64_t dt_ns = is_first ? 0 : rounded;
    double seconds = (double)dt_ns / 1e9;
    if (!is_first && !(dt >= 0.0)) {
        dt_ns = INT64_MIN;
        seconds = dt < 0.0 ? -1.0 : dt;
    } else if (!is_first && dt > 1e9) {
        dt_ns = INT64_MAX;
        seconds = (double)INFINITY;
    }
    s->program->step(state, s->params, dt_ns, seconds, input, output);
}

static void step(const struct stepper *s, void *state, bool is_first, double dt, const void *input,
                 void *output)
{
    if (s->in_table)
        step_in_table(s, state, is_first, dt, input, output);
    else if (s->is_single)
        step_in_floats(s, state, (float)dt, input, output);
    else
        step_in_doubles(s, state, dt, input, output);
}

/* Runs all instants and writes the rows to `text`. Returns the text of an unreadable cell, or
 * NULL. */
static const char *instants(const struct frob_program *program, const struct stepper *stepper,
                            const struct columns *columns, value dts, value times, value rows,
                            void *state, void *input, void *output, struct frob_text *text)
{
    struct frob_cell_error error;
    program->reset(state, stepper->params);
    for (mlsize_t i = 0; i < Wosize_val(rows); i++) {
        const int64_t now = (int64_t)Long_val(Field(times, i));
        for (size_t k = 0; k < columns->count; k++) {
            const char *cell = String_val(Field(Field(rows, i), k));
            if (!frob_cell_read(cell, columns->values[k], input, frames_of_fuzz(), &error))
                return cell;
        }
        step(stepper, state, i == 0, Double_flat_field(dts, i), input, output);
        frob_trace_row(text, program, FROB_TRACE_OUT, now, NULL, output);
    }
    return NULL;
}

/* Runs everything again from the current state, to detect data that `reset` does not clear, and
 * differences between the table's step and NAME_step. */
static bool same_again(const struct frob_program *program, const struct stepper *stepper,
                       const struct columns *columns, value dts, value times, value rows,
                       void *state, void *input, void *output, const struct frob_text *first,
                       struct frob_text *second)
{
    frob_trace_header(second, program, FROB_TRACE_OUT);
    return instants(program, stepper, columns, dts, times, rows, state, input, output, second) ==
               NULL &&
           strcmp(first->data, second->data) == 0;
}

/* Memory filled with garbage, as a careless caller might pass it, so that reads of uninitialized
 * memory change the results. */
static void *litter(size_t size)
{
    void *memory = malloc(size + 1);
    if (memory == NULL)
        abort();
    return memset(memory, 0xa5, size + 1);
}

/* Finds NAME_step in the object. */
static const void *step_function(const struct in_process *p)
{
    char name[256];
    const int length = snprintf(name, sizeof name, "%s_step", p->program->name);
    return length < (int)sizeof name ? tcc_get_symbol(p->compiler, name) : NULL;
}

/* Creates the parameter struct from these cells. */
static void *params_of(const struct frob_program *program, value cells)
{
    struct frob_cell_error error;
    void *params = litter(program->params_size);
    if (Wosize_val(cells) != program->param_count)
        abort();
    for (size_t i = 0; i < program->param_count; i++)
        if (!frob_cell_read(String_val(Field(cells, i)), program->params[i].value, params, NULL,
                            &error))
            abort();
    return params;
}

/* in_process_run : t -> bool * bool * string array -> float array -> int array ->
 * string array array -> string -- runs a recording. The arguments are: whether dt is rounded as a
 * float, whether the second run uses NAME_step, and the values of the parameters; the dt of each
 * step in seconds; the absolute time of each row in nanoseconds; and its cells. Returns the trace
 * of the output. */
value in_process_run(value v, value how, value dts, value times, value rows)
{
    CAMLparam5(v, how, dts, times, rows);
    CAMLlocal1(result);
    const struct frob_program *program = of_value(v)->program;
    void *params = params_of(program, Field(how, 2));
    const struct stepper stepper = { program, params, Bool_val(Field(how, 0)), true, NULL };
    const struct stepper second = { program, params, Bool_val(Field(how, 0)),
                                    !Bool_val(Field(how, 1)), step_function(of_value(v)) };
    const size_t room = frob_trace_room(program, FROB_TRACE_OUT) * (Wosize_val(rows) + 1);
    char *buffer = (char *)litter(room), *buffer_again = (char *)litter(room);
    void *state = litter(program->state_size), *input = litter(program->input_size),
         *output = litter(program->output_size);
    struct frob_text text = frob_text_in(buffer, room);
    struct frob_text again = frob_text_in(buffer_again, room);
    volatile bool restarts = true;
    struct columns columns = { NULL, 0 };
    struct sigaction action, old[SIGNALS];
    const char *volatile unread = NULL;
    int caught;

    if (second.seconds == NULL)
        abort();
    frob_trace_columns(program->input, "in", add_column, &columns);
    frob_trace_header(&text, program, FROB_TRACE_OUT);
    memset(&action, 0, sizeof action);
    action.sa_handler = return_from;
    action.sa_flags = SA_ONSTACK | SA_NODEFER;
    sigemptyset(&action.sa_mask);
    for (int i = 0; i < SIGNALS; i++)
        sigaction(signals[i], &action, &old[i]);
    caught = sigsetjmp(back, 1);
    if (caught == 0) {
        alarm(PATIENCE);
        unread =
            instants(program, &stepper, &columns, dts, times, rows, state, input, output, &text);
        restarts = same_again(program, &second, &columns, dts, times, rows, state, input, output,
                              &text, &again);
    }
    alarm(0);
    for (int i = 0; i < SIGNALS; i++)
        sigaction(signals[i], &old[i], NULL);
    if (caught == 0 && unread == NULL && restarts)
        result = caml_alloc_initialized_string(text.length, buffer);
    free(columns.values);
    free(params);
    free(state);
    free(input);
    free(output);
    free(buffer);
    free(buffer_again);
    if (caught == SIGALRM)
        caml_failwith("the compiled program does not come to the end of its recording");
    if (caught != 0)
        caml_failwith("the compiled program crashes");
    if (unread != NULL)
        caml_failwith("a cell of the input is not read");
    if (!restarts)
        caml_failwith(
            "the compiled program computes something else after a second reset, or with NAME_step");
    CAMLreturn(result);
}
