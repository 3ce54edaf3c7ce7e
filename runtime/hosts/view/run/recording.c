#include "recording.h"

#include "seen.h"

#include "../../common/csv.h"
#include "../../common/dialect.h"
#include "../../common/packed.h"
#include "../../common/params.h"
#include "../../common/seconds.h"

#include <frob/cell.h>
#include <frob/console.h>

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#define ROWS 2000 /* number of rows read at a time */

/* If the first time exceeds this, the recording's clock started long before the run. */
#define FAR_NS INT64_C(1000000000000000000)

/* Reads the rows of a file into a recording. */
struct reader {
    struct recording *recording;
    struct frame_reader *frames; /* finds the images */
    const struct signals *signals;
    struct csv csv;
    const struct signal **columns; /* the signal for each cell of a row; NULL if the cell is not
                                    * read */
    size_t width;
    /* The previous row. Most cells do not change from one row to the next, and unchanged cells need
     * not be parsed again. */
    struct {
        char *text;
        size_t *starts;    /* offsets of its cells in the text */
        size_t room, next; /* `next`: the instant after the previous row; 0 if there is no such
                            * row */
    } before;
};

static void note(struct reader *r, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void note(struct reader *r, const char *format, ...)
{
    char text[1000];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    buffer_format(&r->recording->notes, "%s:%lu: %s\n", r->recording->name, r->csv.line, text);
}

static bool give_up(const struct recording *recording, const char *reason)
{
    fprintf(stderr, "error: cannot view %s: %s\n", recording->name, reason);
    return false;
}

static size_t signal_number_of(const struct reader *r, const struct signal *signal)
{
    return (size_t)(signal - r->signals->all);
}

/* Returns whether the viewer computes a column itself and therefore ignores the recorded one. */
static bool is_computed(const char *name)
{
    return strncmp(name, "mode.", 5) == 0 || strncmp(name, "probe.", 6) == 0;
}

/* Column names for a message, which lists only some of them. */
struct names {
    struct buffer text;
    unsigned count;
};

static void add_name(struct names *names, const char *name)
{
    enum { MOST = 4 };
    if (names->count++ < MOST)
        buffer_format(&names->text, "%s`%s`", names->count > 1 ? ", " : "", name);
    else if (names->count == MOST + 1)
        buffer_text(&names->text, " and more");
}

/* Adds a note that lists any missing columns of the program's input. */
static void look_for_inputs(struct reader *r, bool has_others)
{
    struct recording *recording = r->recording;
    struct names missing = { 0 };
    for (size_t i = 0; i < r->signals->count; i++)
        if (r->signals->all[i].side == INPUT && !recording->recorded[i] &&
            !frob_console_is_on(recording->program, r->signals->all[i].value))
            add_name(&missing, r->signals->all[i].name);
    recording->has_all_inputs = missing.count == 0;
    if (missing.count > 0)
        note(r,
             "the recording has no column for the program's input %s, so the viewer cannot run the "
             "program on it and only shows recorded signals%s",
             missing.text.data,
             has_others
                 ? "; to read one from a column with another name, use `--column NAME=COLUMN`"
                 : "");
    buffer_free(&missing.text);
}

static bool read_header(struct reader *r)
{
    struct recording *recording = r->recording;
    struct names foreign = { 0 };
    enum csv_status status = csv_next(&r->csv);
    for (; status == CSV_ROW && csv_cell(&r->csv, 0)[0] == '#'; status = csv_next(&r->csv)) {
        const char *setting = params_of_line(csv_cell(&r->csv, 0));
        if (setting != NULL)
            buffer_bytes(&recording->params, setting, strlen(setting) + 1);
    }
    if (status == CSV_END)
        return give_up(recording, "the file is empty");
    if (status == CSV_RETURN)
        return give_up(recording, CSV_RETURN_REASON);
    if (status == CSV_NO_COLUMN)
        return give_up(recording, r->csv.reason);
    if (status != CSV_ROW)
        return give_up(recording, "it is not a recording: the first column must be `time`");
    if (strcmp(csv_cell(&r->csv, 0), "time") != 0) {
        char reason[800];
        snprintf(reason, sizeof reason, "it is not a recording: the first column must be `time`%s",
                 dialect_time_hint(&r->csv));
        return give_up(recording, reason);
    }
    r->width = r->csv.count;
    r->columns = (const struct signal **)calloc(r->width, sizeof *r->columns);
    recording->recorded = (bool *)calloc(r->signals->count + 1, sizeof *recording->recorded);
    if (r->columns == NULL || recording->recorded == NULL)
        return give_up(recording, "not enough memory");
    for (size_t i = 1; i < r->width; i++) {
        const char *name = csv_cell(&r->csv, i);
        const struct signal *signal = is_computed(name) ? NULL : signals_find(r->signals, name);
        if (signal == NULL && !is_computed(name)) {
            add_name(&foreign, name);
        } else if (signal != NULL && recording->recorded[signal_number_of(r, signal)]) {
            note(r, "the column `%s` occurs twice", name);
        } else if (signal != NULL) {
            r->columns[i] = signal;
            recording->recorded[signal_number_of(r, signal)] = true;
        }
    }
    if (foreign.count > 0 && !dialect_names(&r->csv.dialect))
        note(r,
             "the program has no %s: the recording is from another program, or from another "
             "version of it",
             foreign.text.data);
    buffer_free(&foreign.text);
    look_for_inputs(r, foreign.count > 0);
    return true;
}

static bool grow(struct recording *recording)
{
    const struct frob_program *program = recording->program;
    size_t capacity = recording->capacity == 0 ? 1024 : recording->capacity * 2;
    int64_t *times;
    unsigned char *bytes;
    if (recording->count < recording->capacity)
        return true;
    times = (int64_t *)realloc(recording->times, capacity * sizeof *times);
    if (times == NULL)
        return false;
    recording->times = times;
    bytes = (unsigned char *)realloc(recording->inputs, capacity * program->input_size + 1);
    if (bytes == NULL)
        return false;
    recording->inputs = bytes;
    bytes = (unsigned char *)realloc(recording->outputs, capacity * recording->output_size + 1);
    if (bytes == NULL)
        return false;
    recording->outputs = bytes;
    bytes = (unsigned char *)realloc(recording->truths, capacity * recording->truth_size + 1);
    if (bytes == NULL)
        return false;
    recording->truths = bytes;
    recording->capacity = capacity;
    return true;
}

/* Returns whether a cell is the same as in the previous row. */
static bool is_as_before(const struct reader *r, size_t i)
{
    return strcmp(csv_cell(&r->csv, i), r->before.text + r->before.starts[i]) == 0;
}

/* Stores the row as the previous one. If memory runs out, every cell of the next row will be
 * parsed again. */
static void remember(struct reader *r)
{
    const char *text = csv_cell(&r->csv, 0), *last = csv_cell(&r->csv, r->width - 1);
    const size_t length = (size_t)(last - text) + strlen(last) + 1;
    r->before.next = 0;
    if (r->before.starts == NULL)
        r->before.starts = (size_t *)malloc(r->width * sizeof *r->before.starts);
    if (length > r->before.room) {
        free(r->before.text);
        r->before.room = 2 * length;
        r->before.text = (char *)malloc(r->before.room);
    }
    if (r->before.text == NULL || r->before.starts == NULL) {
        r->before.room = r->before.text == NULL ? 0 : r->before.room;
        return;
    }
    memcpy(r->before.text, text, length);
    for (size_t i = 0; i < r->width; i++)
        r->before.starts[i] = (size_t)(csv_cell(&r->csv, i) - text);
    r->before.next = r->recording->count;
}

/* Returns true if a value cannot be read because its frame is missing, and records the missing
 * frame. */
static bool lost_frame(struct reader *r, const struct signal *signal, const char *cell,
                       unsigned char *input)
{
    const char *name = strstr(cell, "Image ");
    if (signal->side != INPUT || !seen_is_eye(signal->value) || name == NULL ||
        r->frames->expected[0] == '\0')
        return false;
    seen_lose(r->recording, r->recording->count, input, signal->value,
              (uint32_t)strtoul(name + strlen("Image "), NULL, 10), false);
    return true;
}

/* Reads the current row as the next instant. If it is invalid, notes the reason and returns
 * false. */
static bool read_row(struct reader *r)
{
    struct recording *recording = r->recording;
    const size_t k = recording->count;
    unsigned char *input = recording->inputs + k * recording->program->input_size;
    unsigned char *output = recording->outputs + k * recording->output_size;
    const bool is_next = k > 0 && r->before.next == k;
    if (r->csv.count != r->width) {
        note(r, "the header names %lu columns, but this row has %lu%s", (unsigned long)r->width,
             (unsigned long)r->csv.count, dialect_width_hint(&r->csv, r->width));
        return false;
    }
    if (!seconds_read(csv_cell(&r->csv, 0), &recording->times[k])) {
        note(r, "`%s` is not a time in seconds%s%s", csv_cell(&r->csv, 0),
             dialect_number_hint(&r->csv, csv_cell(&r->csv, 0)),
             seconds_too_far(csv_cell(&r->csv, 0)));
        return false;
    }
    if (k == 0 && (recording->times[0] >= FAR_NS || recording->times[0] <= -FAR_NS)) {
        recording->origin = recording->times[0];
        note(r, "times are shown relative to the first instant, which is at %s s",
             csv_cell(&r->csv, 0));
    }
    recording->times[k] -= recording->origin;
    if (k > 0 && recording->times[k] < recording->times[k - 1]) {
        note(r, "the time goes backwards: `%s` comes after a later time", csv_cell(&r->csv, 0));
        return false;
    }
    if (is_next) {
        memcpy(input, input - recording->program->input_size, recording->program->input_size);
        memcpy(output, output - recording->output_size, recording->output_size);
    } else {
        memset(input, 0, recording->program->input_size);
        frob_console_start(recording->program, input);
        memset(output, 0, recording->output_size);
    }
    for (size_t i = 1; i < r->width; i++) {
        const struct signal *signal = r->columns[i];
        struct frob_cell_error error;
        if (signal == NULL || (is_next && is_as_before(r, i)))
            continue;
        r->frames->expected[0] = '\0';
        if (!frob_cell_read(csv_cell(&r->csv, i), signal->value,
                            signal->side == INPUT ? input : output, &r->frames->finder, &error) &&
            !lost_frame(r, signal, csv_cell(&r->csv, i), input)) {
            const char *expected = error.choice == NULL ? error.expected : NULL;
            note(r, "column `%s`: `%s` is not a valid value%s%s%s", signal->name,
                 csv_cell(&r->csv, i), expected == NULL ? "" : "; expected ",
                 expected == NULL ? "" : expected,
                 dialect_number_hint(&r->csv, csv_cell(&r->csv, i)));
            return false;
        }
    }
    recording->count++;
    remember(r);
    return true;
}

/* Reads some rows. Returns false if there are no more. */
static bool read_rows(struct reader *r)
{
    const char *and_after = "; this row and the rows after it are omitted";
    for (size_t i = 0; i < ROWS; i++) {
        enum csv_status status;
        if (!grow(r->recording)) {
            note(r, "not enough memory%s", and_after);
            return false;
        }
        status = csv_next(&r->csv);
        if (status == CSV_END)
            return false;
        /* A host writes whole lines, so a row without a line feed at the end of the file is
         * incomplete. */
        if ((status == CSV_ROW || status == CSV_UNCLOSED_QUOTE) && feof(r->csv.file)) {
            note(r,
                 "the last line is incomplete (it does not end with a line feed) and is omitted");
            return false;
        }
        if (status != CSV_ROW) {
            note(r, "%s%s",
                 status == CSV_UNREADABLE  ? packed_reason(r->recording->name, errno)
                 : status == CSV_NO_MEMORY ? "not enough memory"
                 : status == CSV_TOO_LONG  ? "a row exceeds 16 MB or a million cells"
                                           : "this is not CSV",
                 and_after);
            return false;
        }
        if (!read_row(r)) {
            /* The reason is the last line of the notes, so this text is appended to it. */
            r->recording->notes.length--;
            buffer_format(&r->recording->notes, "%s\n", and_after);
            return false;
        }
    }
    return true;
}

static void end_reader(struct reader *r)
{
    fclose(r->csv.file);
    csv_end(&r->csv);
    free(r->columns);
    free(r->before.text);
    free(r->before.starts);
}

static void stop_reading(struct recording *recording)
{
    if (recording->reader != NULL)
        end_reader(recording->reader);
    free(recording->reader);
    recording->reader = NULL;
}

bool recording_read_on(struct recording *recording)
{
    if (recording->reader != NULL && !read_rows(recording->reader))
        stop_reading(recording);
    return recording->reader != NULL;
}

bool recording_read(struct recording *recording, const struct signals *signals, const char *name,
                    const struct csv_dialect *dialect)
{
    struct reader *reader = (struct reader *)calloc(1, sizeof *reader);
    FILE *file = packed_read(name);
    bool ok;
    memset(recording, 0, sizeof *recording);
    recording->program = signals->program;
    recording->name = name;
    recording->gap = NO_GAP;
    recording->output_size = signals_output_size(signals);
    if (file == NULL || reader == NULL || !seen_start(recording) ||
        !frame_reader_open(&recording->frames, name, false)) {
        const char *reason = file == NULL ? packed_reason(name, errno) : "not enough memory";
        free(reader);
        if (file != NULL)
            fclose(file);
        return give_up(recording, reason);
    }
    reader->recording = recording;
    reader->frames = &recording->frames;
    reader->signals = signals;
    csv_start(&reader->csv, file, dialect);
    recording->reader = reader;
    ok = read_header(reader);
    if (ok && !recording_read_on(recording) && recording->count == 0) {
        fputs(recording->notes.length > 0 ? recording->notes.data : "", stderr);
        ok = give_up(recording, "it contains no instant");
    }
    if (!ok)
        stop_reading(recording);
    return ok;
}

bool recording_begin(struct recording *recording, const struct signals *signals, const char *name,
                     size_t truth_size)
{
    memset(recording, 0, sizeof *recording);
    recording->program = signals->program;
    recording->name = name;
    recording->gap = NO_GAP;
    recording->output_size = signals_output_size(signals);
    recording->truth_size = truth_size;
    recording->has_all_inputs = true;
    recording->recorded = (bool *)calloc(signals->count + 1, sizeof *recording->recorded);
    if (recording->recorded == NULL || !seen_start(recording) ||
        !frame_reader_open(&recording->frames, name, false))
        return give_up(recording, "not enough memory");
    for (size_t i = 0; i < signals->count; i++)
        recording->recorded[i] = signals->all[i].side == INPUT || signals->all[i].side == OUTPUT;
    return true;
}

bool recording_add(struct recording *recording, int64_t time_ns, const void *input,
                   const void *output, size_t output_size, const void *truth)
{
    const size_t k = recording->count, input_size = recording->program->input_size;
    unsigned char *place;
    if (!grow(recording))
        return false;
    recording->times[k] = time_ns;
    memcpy(recording->inputs + k * input_size, input, input_size);
    place = recording->outputs + k * recording->output_size;
    memset(place, 0, recording->output_size);
    memcpy(place, output,
           output_size < recording->output_size ? output_size : recording->output_size);
    place = recording->truths + k * recording->truth_size;
    if (truth != NULL)
        memcpy(place, truth, recording->truth_size);
    else if (k > 0)
        memcpy(place, place - recording->truth_size, recording->truth_size);
    else
        memset(place, 0, recording->truth_size);
    recording->count++;
    return true;
}

struct catching {
    struct recording row; /* contains one row at a time */
    struct reader reader;
    size_t k; /* instant of the next row */
};

struct catching *catching_start(const struct signals *signals, const char *name)
{
    struct catching *catching = (struct catching *)calloc(1, sizeof *catching);
    FILE *file = packed_by(name) == NULL ? fopen(name, "rb") : NULL;
    if (catching == NULL || file == NULL) {
        free(catching);
        if (file != NULL)
            fclose(file);
        return NULL;
    }
    catching->row.program = signals->program;
    catching->row.name = name;
    catching->row.output_size = signals_output_size(signals);
    catching->reader.recording = &catching->row;
    catching->reader.signals = signals;
    csv_start(&catching->reader.csv, file, NULL);
    if (read_header(&catching->reader) && catching->row.has_all_inputs)
        return catching;
    catching_end(catching);
    return NULL;
}

bool catching_take(struct catching *catching, struct recording *recording, size_t end)
{
    const struct recording *row = &catching->row;
    catching->reader.frames = &recording->frames;
    clearerr(catching->reader.csv.file);
    for (; catching->k < end; catching->k++) {
        if (csv_next(&catching->reader.csv) != CSV_ROW || feof(catching->reader.csv.file))
            return false;
        if (catching->k < recording->count)
            continue;
        catching->row.count = 0;
        if (!grow(&catching->row) || !read_row(&catching->reader) ||
            !recording_add(recording, row->times[0], row->inputs, row->outputs, row->output_size,
                           NULL))
            return false;
    }
    return true;
}

void catching_end(struct catching *catching)
{
    if (catching == NULL)
        return;
    end_reader(&catching->reader);
    recording_free(&catching->row);
    free(catching);
}

bool recording_set(struct recording *recording, const char *const *params, size_t count)
{
    const size_t recorded = recording->params.length;
    struct params values;
    char why[PARAMS_WHY];
    bool ok = params_open(&values, recording->program, params, count);
    for (size_t at = 0; ok && at < recorded; at += strlen(recording->params.data + at) + 1)
        if (params_read(&values, recording->params.data + at, why) != PARAMS_SET)
            buffer_format(&recording->notes, "%s: %s\n", recording->name, why);
    for (size_t i = 0; ok && i < count; i++)
        buffer_bytes(&recording->params, params[i], strlen(params[i]) + 1);
    params_close(&values);
    return ok;
}

void recording_free(struct recording *recording)
{
    stop_reading(recording);
    free(recording->truths);
    free(recording->times);
    free(recording->inputs);
    free(recording->outputs);
    free(recording->recorded);
    free(recording->eyes);
    free(recording->lost);
    frame_reader_close(&recording->frames);
    buffer_free(&recording->notes);
    buffer_free(&recording->params);
}

int64_t recording_dt_ns(const struct recording *recording, size_t k)
{
    return k == 0 ? 0 : recording->times[k] - recording->times[k - 1];
}

const void *recording_input(const struct recording *recording, size_t k)
{
    return recording->inputs + k * recording->program->input_size;
}

const void *recording_truth(const struct recording *recording, size_t k)
{
    return recording->truths + k * recording->truth_size;
}

const void *recording_output(const struct recording *recording, size_t k)
{
    return recording->outputs + k * recording->output_size;
}
