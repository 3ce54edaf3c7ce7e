/* frob-trace -- runs a compiled program on recorded input: CSV in, CSV out.
 *
 *   frob-trace [--modes] [--stop-when-violated] [--param NAME=VALUE]... [--separator C]
 *              [--decimal-comma] [--time-column NAME] [--column NAME=COLUMN]...
 *              PROGRAM.so IN.csv [OUT.csv]
 *
 * If IN.csv is `-`, reads standard input; without OUT.csv, writes to standard output. --modes adds
 * a column for each machine, with its current mode. --param sets a parameter; other parameters
 * keep the values with which the recording was made. The options from --separator on are for
 * recordings from other programs (dialect.h). Camera frames are read from IN.frames, next to the
 * recording. The results of the program's assertions are printed on standard error. Exit status: 0;
 * 2 if a file cannot be read or written or is not a trace of this program; 4 with
 * --stop-when-violated, which stops at the first instant at which an assertion is violated.
 * <frob/trace.h> describes the trace's format. */
#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* open_memstream */
#endif

#include "../common/claims.h"
#include "../common/csv.h"
#include "../common/dialect.h"
#include "../common/frames.h"
#include "../common/load.h"
#include "../common/packed.h"
#include "../common/params.h"
#include "../common/seconds.h"
#include "../common/streams.h"

#include <frob/cell.h>
#include <frob/console.h>
#include <frob/trace.h>

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum { DONE = 0, WRONG_USE = 2, FAULT = 4 };

/* One column of the program's input. */
struct column {
    char *name;
    const struct frob_value *value;
    size_t cell; /* index of the column in the file's rows */
    bool found;
    bool on_console; /* whether the column belongs to a console control; if it is missing, nobody
                      * touched that control */
};

struct trace {
    const struct frob_program *program;
    struct params params;
    const char *input_name;
    struct csv csv;
    struct frame_reader frames; /* the camera frames, stored next to the recording */
    FILE *output;
    struct column *columns;
    size_t count, capacity;
    size_t width;   /* number of cells in the header */
    unsigned parts; /* which groups of columns the output has */
    struct claims claims;
    bool stops; /* whether to stop when an assertion is violated */
    bool no_memory;
};

static void complain(const struct trace *t, size_t cell, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* A message that stays on one line, whatever characters its names and cells contain. */
struct complaint {
    FILE *stream; /* NULL if memory ran out */
    char *text;
    size_t length;
};

static void begin(struct complaint *c)
{
    c->text = NULL;
    c->stream = open_memstream(&c->text, &c->length);
}

/* Begins a message with the file, the line, and the column in that line. */
static void begin_complaint(struct complaint *c, const struct trace *t, size_t cell)
{
    begin(c);
    if (c->stream != NULL)
        fprintf(c->stream, "error: %s:%lu:%lu: ", t->input_name, t->csv.line,
                (unsigned long)(cell < t->csv.count ? t->csv.columns[cell] : 1));
}

/* Writes line feeds and tabs as decimal codes. Standard error does the same for other control
 * characters (streams.h). */
static void end_complaint(struct complaint *c)
{
    if (c->stream == NULL || fclose(c->stream) != 0) {
        fputs("error: not enough memory for a message\n", stderr);
    } else {
        for (const char *at = c->text; *at != '\0'; at++) {
            if (*at == '\n' || *at == '\t')
                fprintf(stderr, "\\%03d", *at);
            else
                fputc(*at, stderr);
        }
        fputc('\n', stderr);
    }
    free(c->text);
}

static void complain(const struct trace *t, size_t cell, const char *format, ...)
{
    struct complaint c;
    va_list arguments;
    begin_complaint(&c, t, cell);
    va_start(arguments, format);
    if (c.stream != NULL)
        vfprintf(c.stream, format, arguments);
    va_end(arguments);
    end_complaint(&c);
}

/* `what` is "read" or "write". */
static void complain_of_file(const char *what, const char *name)
{
    const char *reason = packed_reason(name, errno);
    struct complaint c;
    begin(&c);
    if (c.stream != NULL)
        fprintf(c.stream, "error: cannot %s %s: %s", what, name, reason);
    end_complaint(&c);
}

static void add_column(void *context, const char *name, const struct frob_value *value)
{
    struct trace *t = (struct trace *)context;
    if (t->count == t->capacity) {
        size_t capacity = t->capacity == 0 ? 32 : t->capacity * 2;
        struct column *columns = (struct column *)realloc(t->columns, capacity * sizeof *columns);
        if (columns == NULL) {
            t->no_memory = true;
            return;
        }
        t->columns = columns;
        t->capacity = capacity;
    }
    t->columns[t->count].name = (char *)malloc(strlen(name) + 1);
    if (t->columns[t->count].name == NULL) {
        t->no_memory = true;
        return;
    }
    strcpy(t->columns[t->count].name, name);
    t->columns[t->count].value = value;
    t->columns[t->count].found = false;
    t->columns[t->count].on_console = frob_console_is_on(t->program, value);
    t->count++;
}

/* Reports any status of csv_next other than CSV_ROW and CSV_END. */
static bool readable(const struct trace *t, enum csv_status status)
{
    switch (status) {
    case CSV_ROW:
    case CSV_END: return true;
    case CSV_UNREADABLE:
        complain(t, 0, "cannot read the file: %s", packed_reason(t->input_name, errno));
        break;
    case CSV_UNCLOSED_QUOTE:
        complain(t, 0, "a quoted cell that starts in this row is never closed");
        break;
    case CSV_LATE_QUOTE:
        complain(t, t->csv.count - 1,
                 "there is a space before a quote; remove the spaces next to the commas");
        break;
    case CSV_NUL: complain(t, 0, "there is a zero byte: this is not a CSV file"); break;
    case CSV_RETURN: complain(t, 0, "%s", CSV_RETURN_REASON); break;
    case CSV_NO_COLUMN: complain(t, 0, "%s", t->csv.reason); break;
    case CSV_TOO_LONG:
        complain(t, 0,
                 "the row is larger than 16 MB or has more than a million cells: this is not a "
                 "recording");
        break;
    case CSV_NO_MEMORY: complain(t, 0, "not enough memory for this row"); break;
    }
    return false;
}

/* Returns the end of a message about a column's name or a time. Spaces next to commas are part of
 * the name or time but hard to see, so the message points them out. Without such spaces, returns
 * "". */
static const char *on_blanks(const char *text)
{
    size_t length = strlen(text);
    bool blank = length > 0 && (text[0] == ' ' || text[0] == '\t' || text[length - 1] == ' ' ||
                                text[length - 1] == '\t');
    return blank ? "; remove the spaces next to the commas" : "";
}

static bool is_output(const char *name)
{
    return strncmp(name, "mode.", 5) == 0 || strncmp(name, "probe.", 6) == 0 ||
           (strncmp(name, "out", 3) == 0 && (name[3] == '\0' || name[3] == '.' || name[3] == '['));
}

static struct column *find_column(struct trace *t, const char *name)
{
    for (size_t i = 0; i < t->count; i++)
        if (strcmp(t->columns[i].name, name) == 0)
            return &t->columns[i];
    return NULL;
}

static bool is_missing(const struct column *column)
{
    return !column->found && !column->on_console;
}

/* Reports the columns that are missing from the header. Names only a few of them, because a robot's
 * input has many columns, and the message also contains the expected header. `unknown`: the number
 * of unknown columns in the header; `other`: one of them. */
static void complain_missing(struct trace *t, size_t unknown, const char *other)
{
    const char *first = NULL;
    enum { MOST = 4 };
    const char *comma = "";
    size_t missing = 0, named = 0;
    for (size_t i = 0; i < t->count; i++)
        missing += is_missing(&t->columns[i]) ? 1 : 0;
    const size_t most = missing <= MOST ? missing : MOST - 1;
    struct complaint c;
    begin_complaint(&c, t, t->csv.count);
    if (c.stream == NULL) {
        end_complaint(&c);
        return;
    }
    fputs("missing: ", c.stream);
    for (size_t i = 0; i < t->count && named < most; i++) {
        if (is_missing(&t->columns[i])) {
            fprintf(c.stream, "%s`%s`", comma, t->columns[i].name);
            first = first == NULL ? t->columns[i].name : first;
            comma = ", ";
            named++;
        }
    }
    if (named < missing)
        fprintf(c.stream, " and %lu more", (unsigned long)(missing - named));
    fputs("; the header for this program is `time", c.stream);
    for (size_t i = 0; i < t->count; i++)
        fprintf(c.stream, ",%s", t->columns[i].name);
    fprintf(c.stream, "`%s", dialect_column_hint(&t->csv, first, unknown, other));
    end_complaint(&c);
}

static bool read_header(struct trace *t)
{
    bool ok = true;
    size_t unknown = 0;
    const char *other = NULL;
    enum csv_status status = csv_next(&t->csv);
    while (status == CSV_ROW && csv_cell(&t->csv, 0)[0] == '#') {
        if (!params_recorded(&t->params, t->input_name, csv_cell(&t->csv, 0)))
            return false;
        status = csv_next(&t->csv);
    }
    if (!readable(t, status))
        return false;
    if (status == CSV_END) {
        complain(t, 0, "the file is empty: its first line must name the columns, `time` first");
        return false;
    }
    t->width = t->csv.count;
    if (strcmp(csv_cell(&t->csv, 0), "time") != 0) {
        const char *name = csv_cell(&t->csv, 0), *blanks = on_blanks(name);
        complain(t, 0, "the first column must be `time`, but it is `%s`%s", name,
                 blanks[0] != '\0' ? blanks : dialect_time_hint(&t->csv));
        if (dialect_separator_hint(&t->csv) != NULL)
            return false;
        ok = false;
    }
    for (size_t i = 1; i < t->csv.count; i++) {
        const char *name = csv_cell(&t->csv, i);
        struct column *column = find_column(t, name);
        if (column != NULL && column->found) {
            complain(t, i, "the column `%s` occurs twice", name);
            ok = false;
        } else if (column != NULL) {
            column->found = true;
            column->cell = i;
        } else if (!is_output(name)) {
            if (on_blanks(name)[0] == '\0') {
                unknown++;
                other = name;
            }
            if (dialect_names(&t->csv.dialect))
                continue;
            complain(t, i, "the program's input has no `%s`%s", name, on_blanks(name));
            ok = false;
        }
    }
    for (size_t i = 0; i < t->count; i++) {
        if (is_missing(&t->columns[i])) {
            complain_missing(t, unknown, other);
            return false;
        }
    }
    return ok;
}

static bool is_blank(const char *cell)
{
    return cell[strspn(cell, " \t")] == '\0';
}

/* Lists the constructors as `A`, `B` or `C`, truncated at the end of the buffer. */
static const char *constructors(char *buffer, size_t size, const struct frob_value *value)
{
    size_t length = 0;
    for (size_t i = 0; i < value->count && length < size; i++) {
        const char *between = i == 0 ? "" : i + 1 < value->count ? ", " : " or ";
        int written = snprintf(buffer + length, size - length, "%s`%s`", between,
                               value->constructors[i].name);
        length += written > 0 ? (size_t)written : 0;
    }
    return buffer;
}

static void complain_of_cell(const struct trace *t, const struct column *column, const char *cell,
                             const struct frob_cell_error *error)
{
    char choice[1000];
    const char *expected = error->choice != NULL
                               ? constructors(choice, sizeof choice, error->choice)
                               : error->expected;
    if (is_blank(cell))
        complain(t, column->cell, "column `%s`: expected %s, found an empty cell", column->name,
                 expected);
    else
        complain(t, column->cell, "column `%s`: expected %s, found `%s`%s", column->name, expected,
                 cell, dialect_number_hint(&t->csv, cell));
}

static bool read_row(struct trace *t, void *input, int64_t *time)
{
    struct frob_cell_error error;
    if (t->csv.count != t->width) {
        complain(t, t->width,
                 "wrong number of cells: the header has %lu columns, but this row has %lu%s",
                 (unsigned long)t->width, (unsigned long)t->csv.count,
                 dialect_width_hint(&t->csv, t->width));
        return false;
    }
    if (!seconds_read(csv_cell(&t->csv, 0), time)) {
        const char *text = csv_cell(&t->csv, 0);
        complain(t, 0, "`%s` is not a time in seconds%s%s%s", text, on_blanks(text),
                 dialect_number_hint(&t->csv, text), seconds_too_far(text));
        return false;
    }
    frame_reader_forget(&t->frames);
    for (size_t i = 0; i < t->count; i++) {
        const struct column *column = &t->columns[i];
        const char *cell = column->found ? csv_cell(&t->csv, column->cell) : NULL;
        if (cell != NULL &&
            !frob_cell_read(cell, column->value, input, &t->frames.finder, &error)) {
            complain_of_cell(t, column, cell, &error);
            return false;
        }
    }
    return true;
}

static bool cannot_write(const char *output_name)
{
    complain_of_file("write", output_name);
    return false;
}

static bool flush(const struct trace *t, struct frob_text *text, const char *output_name)
{
    if (fwrite(text->data, 1, text->length, t->output) != text->length) {
        return cannot_write(output_name);
    }
    frob_text_clear(text);
    return true;
}

/* Runs the program, with one instant for each row. */
static int run(struct trace *t, const char *output_name)
{
    const struct frob_program *program = t->program;
    size_t room = frob_trace_room(program, t->parts);
    char *buffer = (char *)malloc(room);
    void *state = calloc(1, program->state_size + 1);
    void *input = calloc(1, program->input_size + 1);
    void *output = calloc(1, program->output_size + 1);
    int64_t before = 0, now = 0, dt_ns;
    bool first = true, ok = true;
    if (buffer == NULL || state == NULL || input == NULL || output == NULL) {
        fprintf(stderr, "error: not enough memory for the program's state\n");
        ok = false;
    } else {
        struct frob_text text = frob_text_in(buffer, room);
        enum csv_status status = CSV_END;
        frob_trace_header(&text, program, t->parts);
        ok = flush(t, &text, output_name);
        frob_console_start(program, input);
        program->reset(state, t->params.values);
        while (ok && (status = csv_next(&t->csv)) == CSV_ROW) {
            ok = read_row(t, input, &now);
            if (ok && !first && now < before) {
                complain(t, 0, "the time goes backwards: `%s` comes after a later time",
                         csv_cell(&t->csv, 0));
                ok = false;
            }
            if (!ok)
                break;
            dt_ns = first ? 0 : now - before;
            if (!program->is_valid(state)) {
                complain(t, 0, "the state of %s is damaged: " FROB_DAMAGED_STATE, program->name);
                ok = false;
                break;
            }
            program->step(state, t->params.values, dt_ns, (double)dt_ns / 1e9, input, output);
            if ((t->parts & FROB_TRACE_MODES) != 0)
                frob_trace_row_with_modes(&text, program, t->parts, now, NULL, output, state);
            else
                frob_trace_row(&text, program, t->parts, now, NULL, output);
            ok = flush(t, &text, output_name);
            if (!t->claims.nan_is_given && claims_has_nan(program->input, input))
                t->claims.nan_is_given = true;
            claims_see(&t->claims, now, output);
            if (t->stops && t->claims.violated != NULL)
                break;
            before = now;
            first = false;
        }
        ok = ok && readable(t, status);
    }
    free(output);
    free(input);
    free(state);
    free(buffer);
    if (!ok)
        return WRONG_USE;
    return t->stops && t->claims.violated != NULL ? FAULT : DONE;
}

struct arguments {
    const char **params; /* settings */
    size_t param_count;
    struct csv_dialect dialect;
    bool modes, stops;
    const char *program, *input, *output; /* standard output if output is NULL */
};

static bool read_arguments(int argc, char **argv, struct arguments *a)
{
    int i = 1;
    a->params = (const char **)calloc((size_t)argc, sizeof *a->params);
    a->dialect.columns = (const char **)calloc((size_t)argc, sizeof *a->dialect.columns);
    for (; a->params != NULL && i < argc && strncmp(argv[i], "--", 2) == 0; i++) {
        if (strcmp(argv[i], "--modes") == 0)
            a->modes = true;
        else if (strcmp(argv[i], "--stop-when-violated") == 0)
            a->stops = true;
        else if (strcmp(argv[i], "--param") == 0 && i + 1 < argc)
            a->params[a->param_count++] = argv[++i];
        else if (!dialect_option(&a->dialect, argc, argv, &i))
            break;
    }
    if (a->params == NULL || argc - i < 2 || argc - i > 3) {
        fprintf(stderr,
                "usage: frob-trace [--modes] [--stop-when-violated] [--param NAME=VALUE]... "
                "[--separator C] [--decimal-comma] [--time-column NAME] "
                "[--column NAME=COLUMN]... PROGRAM.so IN.csv [OUT.csv]\n");
        return false;
    }
    a->program = argv[i];
    a->input = argv[i + 1];
    a->output = argc - i == 3 ? argv[i + 2] : NULL;
    return true;
}

/* A damaged archive may have caused the error, but damage is detected only at the end of the
 * archive. Reads up to 64 MiB of the rest, because a small archive may expand to a huge amount of
 * data, and reports damage. */
static void tell_damage(const char *name, FILE *input)
{
    char some[4096];
    for (size_t n = 0; n < 16384 && fread(some, 1, sizeof some, input) > 0; n++)
        continue;
    if (ferror(input))
        complain_of_file("read", name);
}

static int trace(struct trace *t, const struct arguments *a)
{
    const char *output_name = a->output != NULL ? a->output : "standard output";
    const bool standard = strcmp(a->input, "-") == 0;
    FILE *input;
    int status = WRONG_USE;
    t->parts = FROB_TRACE_OUT | (a->modes ? FROB_TRACE_MODES : 0U);
    t->program = frob_load(a->program);
    t->stops = a->stops;
    if (t->program == NULL || !params_open(&t->params, t->program, a->params, a->param_count) ||
        !claims_open(&t->claims, t->program))
        return WRONG_USE;
    t->input_name = standard ? "standard input" : a->input;
    input = standard ? stdin : packed_read(a->input);
    if (input == NULL) {
        complain_of_file("read", a->input);
        return WRONG_USE;
    }
    csv_start(&t->csv, input, &a->dialect);
    frob_trace_columns(t->program->input, "in", add_column, t);
    if (!frame_reader_open(&t->frames, a->input, true) || t->no_memory) {
        fprintf(stderr, "error: not enough memory for the columns\n");
    } else if (read_header(t)) {
        t->output = a->output != NULL ? packed_write(a->output) : stdout;
        if (t->output == NULL) {
            cannot_write(output_name);
        } else {
            status = run(t, output_name);
            if (fflush(t->output) != 0 && status == DONE) {
                cannot_write(output_name);
                status = WRONG_USE;
            }
            if (status != WRONG_USE)
                claims_print(&t->claims, stderr, "");
            if (status == FAULT)
                claims_complain(&t->claims);
        }
    }
    if (t->output != NULL && t->output != stdout && fclose(t->output) != 0) {
        if (status != WRONG_USE)
            cannot_write(output_name);
        status = WRONG_USE;
    }
    if (status == WRONG_USE && packed_by(t->input_name) != NULL && !ferror(input))
        tell_damage(t->input_name, input);
    frame_reader_close(&t->frames);
    csv_end(&t->csv);
    fclose(input);
    return status;
}

int main(int argc, char **argv)
{
    struct trace t = { 0 };
    struct arguments arguments = { 0 };
    int status = WRONG_USE;
    streams_keep_plain();
    if (read_arguments(argc, argv, &arguments))
        status = trace(&t, &arguments);
    for (size_t i = 0; i < t.count; i++)
        free(t.columns[i].name);
    free(t.columns);
    params_close(&t.params);
    claims_close(&t.claims);
    free(arguments.params);
    free(arguments.dialect.columns);
    return status;
}
