#include "view.h"

#include "condition.h"

#include "../common/truth.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* {1 Beginning} */

static const char *without_folder(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash == NULL ? path : slash + 1;
}

static bool read_source(struct source *source, const char *path)
{
    struct buffer text = { 0 };
    char block[4096];
    size_t length;
    FILE *file = fopen(path, "rb");
    source->name = without_folder(path);
    if (file != NULL) {
        while ((length = fread(block, 1, sizeof block, file)) > 0)
            buffer_bytes(&text, block, length);
        if (ferror(file)) {
            fclose(file);
            file = NULL;
        }
    }
    if (file == NULL) {
        fprintf(stderr, "error: cannot read %s: %s\n", path, strerror(errno));
        buffer_free(&text);
        return false;
    }
    fclose(file);
    buffer_text(&text, "");
    source->text = text.data;
    return source->text != NULL;
}

bool view_start(struct view *view, const struct frob_program *program,
                const struct frob_column *columns, const struct frob_origin *origins,
                const struct view_files *files, struct ring *ring)
{
    memset(view, 0, sizeof *view);
    view->program = program;
    view->origins = origins;
    view->files = files;
    view->sources = (struct source *)calloc(files->source_count + 1, sizeof *view->sources);
    if (view->sources == NULL || !signals_start(&view->signals, program, columns)) {
        fprintf(stderr, "error: not enough memory for the program's signals\n");
        return false;
    }
    for (size_t i = 0; i < files->source_count; i++) {
        if (!read_source(&view->sources[i], files->sources[i]))
            return false;
        view->sources[i].is_library = i >= files->own_count;
        view->source_count++;
    }
    if (files->world != NULL && !read_source(&view->world, files->world))
        return false;
    if (ring != NULL ? !live_start(&view->live, ring, files->recording, &view->signals,
                                   &view->recording)
                     : !recording_read(&view->recording, &view->signals, files->recording))
        return false;
    if (!recording_set(&view->recording, files->params, files->param_count))
        return false;
    if (!replay_start(&view->replay, &view->signals, &view->recording)) {
        fprintf(stderr, "error: not enough memory for the program's states\n");
        return false;
    }
    series_start(&view->series, &view->replay);
    return true;
}

void view_end(struct view *view)
{
    live_end(&view->live);
    what_if_end(&view->other);
    series_end(&view->series);
    replay_end(&view->replay);
    recording_free(&view->recording);
    signals_end(&view->signals);
    for (size_t i = 0; i < view->source_count; i++)
        free(view->sources[i].text);
    free(view->sources);
    free(view->world.text);
}

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + (double)time.tv_nsec / 1e9;
}

bool view_advance(struct view *view, double seconds)
{
    const double end = now() + seconds;
    const bool diverged = view->replay.diverged;
    while (!replay_is_whole(&view->replay)) {
        replay_advance(&view->replay);
        if (now() >= end)
            break;
    }
    if (view->replay.diverged != diverged)
        series_forget(&view->series);
    return !replay_is_whole(&view->replay);
}

/* As often as a screen is drawn. */
#define NEWS_S 0.016

static bool is_live(const struct view *view)
{
    return view->live.ring != NULL;
}

enum view_work view_work(struct view *view, double seconds)
{
    const bool had_ended = view->live.has_ended, was_whole = replay_is_whole(&view->replay);
    bool is_whole;
    if (is_live(view) && !had_ended) {
        view->has_news |= live_take(&view->live, 1000);
        view->has_news |= view->live.has_ended;
    }
    is_whole = !view_advance(view, seconds);
    view->has_news |= is_whole && !was_whole;
    if (!is_whole)
        return VIEW_GOES_ON;
    return is_live(view) && (!view->live.has_ended || view->has_news) ? VIEW_LOOKS : VIEW_RESTS;
}

bool view_has_news(struct view *view)
{
    if (!view->has_news || (is_live(view) && now() < view->told + NEWS_S))
        return false;
    view->has_news = false;
    view->told = now();
    return true;
}

void view_summary(const struct view *view, struct buffer *text)
{
    if (view->recording.notes.length > 0)
        buffer_text(text, view->recording.notes.data);
    if (view->replay.diverged)
        buffer_format(text,
                      "diverged at %lu: `%s` is not as recorded, so the recording is of another "
                      "version of the program, or its C depends on more than its input\n",
                      (unsigned long)view->replay.diverged_at, view->replay.diverged_in->name);
}

/* {1 Answers} */

static void refuse(struct buffer *answer, const char *why)
{
    buffer_text(answer, "{\"is\":\"refused\",\"why\":");
    buffer_string(answer, why);
    buffer_text(answer, "}");
}

static double seconds_at(const struct view *view, size_t k)
{
    return (double)view->recording.times[k] / 1e9;
}

static const char *kind_of(const struct signal *signal)
{
    if (signal->side == MODE)
        return "mode";
    switch (signal->shown->kind) {
    case FROB_BOOL:
        return "bool";
    case FROB_INT:
        return "int";
    case FROB_FLOAT:
    case FROB_SINGLE:
    case FROB_ROUNDED:
        return "float";
    case FROB_SUM:
        return signal->shown->is_event ? "event" : "sum";
    case FROB_PRODUCT:
    case FROB_ARRAY:
        break;
    }
    return "data";
}

/* The names that the numbers of a plot stand for. */
static void add_names(const struct view *view, const struct signal *signal,
                      struct buffer *answer)
{
    const char *comma = "";
    buffer_text(answer, ",\"names\":[");
    if (signal->side == MODE) {
        const struct frob_machine *machine = &view->program->machines[signal->machine];
        for (size_t i = 0; i < machine->count; i++, comma = ",") {
            buffer_text(answer, comma);
            buffer_string(answer, machine->modes[i]);
        }
    } else if (signal->shown->kind == FROB_SUM && !signal->shown->is_event) {
        for (size_t i = 0; i < signal->shown->count; i++, comma = ",") {
            buffer_text(answer, comma);
            buffer_string(answer, signal->shown->constructors[i].name);
        }
    }
    buffer_text(answer, "]");
}

/* What the programmer knows of it. */
static void add_column(const struct signal *signal, struct buffer *answer)
{
    static const struct frob_column unknown = { "", "", 0, "", "", "", 0 };
    const struct frob_column *column = signal->column != NULL ? signal->column : &unknown;
    struct buffer own = { 0 };
    buffer_format(&own, "%s%s", column->own, signal->column != NULL ? signal->below : "");
    buffer_text(answer, ",\"unit\":");
    buffer_string(answer, column->unit);
    buffer_text(answer, ",\"instance\":");
    buffer_string(answer, column->instance);
    buffer_text(answer, ",\"own\":");
    buffer_string(answer, own.length > 0 ? own.data : "");
    buffer_text(answer, ",\"file\":");
    buffer_string(answer, column->file);
    buffer_format(answer, ",\"line\":%u", column->line);
    buffer_free(&own);
}

/* Of the running mode of a machine: from and to, by number, and what it waits for. */
static void add_transitions(const struct view *view, const struct signal *signal,
                            struct buffer *answer)
{
    const struct frob_origin *origin = why_origin(view->origins, signal);
    const struct frob_transition *t = origin == NULL ? NULL : origin->transitions;
    const char *comma = "";
    if (t == NULL)
        return;
    buffer_text(answer, ",\"transitions\":[");
    for (; t->label != NULL; t++, comma = ",") {
        buffer_format(answer, "%s{\"from\":%d,\"to\":%d,\"delayed\":%s,\"label\":", comma, t->from,
                      t->target, t->delayed ? "true" : "false");
        buffer_string(answer, t->label);
        buffer_text(answer, "}");
    }
    buffer_text(answer, "]");
}

static void add_signals(const struct view *view, struct buffer *answer)
{
    static const char *const sides[] = { "input", "output", "probe", "mode" };
    buffer_text(answer, ",\"signals\":[");
    for (size_t i = 0; i < view->signals.count; i++) {
        const struct signal *signal = &view->signals.all[i];
        buffer_text(answer, i > 0 ? ",{\"name\":" : "{\"name\":");
        buffer_string(answer, signal->name);
        buffer_format(answer, ",\"side\":\"%s\",\"kind\":\"%s\"", sides[signal->side],
                      kind_of(signal));
        add_names(view, signal, answer);
        add_column(signal, answer);
        add_transitions(view, signal, answer);
        buffer_text(answer, "}");
    }
    buffer_text(answer, "]");
}

static void add_source(const struct source *source, struct buffer *answer)
{
    if (source->text == NULL) {
        buffer_text(answer, "null");
        return;
    }
    buffer_text(answer, "{\"name\":");
    buffer_string(answer, source->name);
    buffer_format(answer, ",\"library\":%s,\"text\":", source->is_library ? "true" : "false");
    buffer_string(answer, source->text);
    buffer_text(answer, "}");
}

/* What of `program` changes as the program is run on. */
static void add_progress(const struct view *view, struct buffer *message)
{
    struct buffer summary = { 0 };
    view_summary(view, &summary);
    buffer_format(message, ",\"replayed\":%lu,\"notes\":",
                  (unsigned long)(view->replay.runs ? view->replay.reached : 0));
    buffer_string(message, summary.length > 0 ? summary.data : "");
    buffer_free(&summary);
}

/* Of a run that goes on, what grows. */
static void add_extent(const struct view *view, struct buffer *message)
{
    const size_t count = view->recording.count;
    buffer_format(message, ",\"instants\":%lu,\"start\":", (unsigned long)count);
    buffer_number(message, count == 0 ? 0.0 : seconds_at(view, 0));
    buffer_text(message, ",\"end\":");
    buffer_number(message, count == 0 ? 0.0 : seconds_at(view, count - 1));
    buffer_format(message, ",\"live\":%s",
                  is_live(view) && !view->live.has_ended ? "true" : "false");
}

static bool has_outputs(const struct view *view)
{
    for (size_t i = 0; i < view->signals.count; i++)
        if (view->signals.all[i].side == OUTPUT && view->recording.recorded[i])
            return true;
    return false;
}

/* What the operator is asked for, in the order of its numbers, each with its signal. */
static void add_console(const struct view *view, struct buffer *answer)
{
    static const char *const kinds[] = { "button", "hold", "knob", "toggle", "map" };
    buffer_text(answer, ",\"console\":[");
    for (size_t i = 0; i < view->program->control_count; i++) {
        const struct frob_control *control = &view->program->console[i];
        size_t signal = 0;
        while (signal < view->signals.count && view->signals.all[signal].value != control->value)
            signal++;
        buffer_format(answer, "%s{\"kind\":\"%s\",\"label\":", i > 0 ? "," : "",
                      kinds[control->kind]);
        buffer_string(answer, control->label);
        buffer_text(answer, ",\"unit\":");
        buffer_string(answer, control->unit);
        buffer_text(answer, ",\"least\":");
        buffer_number(answer, control->least);
        buffer_text(answer, ",\"most\":");
        buffer_number(answer, control->most);
        buffer_text(answer, ",\"first\":");
        buffer_number(answer, control->first);
        buffer_format(answer, ",\"signal\":%lu}", (unsigned long)signal);
    }
    buffer_text(answer, "]");
}

static void answer_program(struct view *view, struct buffer *answer)
{
    buffer_text(answer, "{\"is\":\"program\",\"name\":");
    buffer_string(answer, view->program->name);
    buffer_text(answer, ",\"robot\":");
    buffer_string(answer, view->program->robot);
    buffer_text(answer, ",\"recording\":");
    buffer_string(answer, is_live(view) ? "" : without_folder(view->recording.name));
    add_extent(view, answer);
    buffer_format(answer, ",\"runs\":%s,\"compared\":%s", view->replay.runs ? "true" : "false",
                  has_outputs(view) ? "true" : "false");
    add_progress(view, answer);
    add_signals(view, answer);
    add_console(view, answer);
    buffer_text(answer, ",\"sources\":[");
    for (size_t i = 0; i < view->source_count; i++) {
        buffer_text(answer, i > 0 ? "," : "");
        add_source(&view->sources[i], answer);
    }
    buffer_text(answer, "],\"world\":");
    add_source(&view->world, answer);
    buffer_text(answer, "}");
}

/* Is anything known of it? If the program cannot be run, only what was recorded. */
static bool is_known(const struct view *view, const struct signal *signal)
{
    return signal->side == INPUT || signal->side == OUTPUT || view->replay.runs;
}

static void add_cell(const struct signals *signals, const struct signal *signal,
                     const struct moment *moment, struct buffer *answer)
{
    struct buffer cell = { 0 };
    signal_write(signals, signal, moment, &cell);
    buffer_string(answer, cell.length > 0 ? cell.data : "");
    buffer_free(&cell);
}

/* Of the edited program, in the same order; null where it has no such signal. */
static void add_other_cells(struct view *view, size_t k, struct buffer *answer)
{
    const struct signals *signals = &view->other.signals;
    const bool is_there = k < view->other.replay.recording->count;
    struct moment moment = { NULL, NULL, NULL };
    if (is_there)
        moment = replay_at(&view->other.replay, k);
    buffer_text(answer, ",\"others\":[");
    for (size_t i = 0; i < view->signals.count; i++) {
        const struct signal *signal = signals_find(signals, view->signals.all[i].name);
        buffer_text(answer, i > 0 ? "," : "");
        if (signal == NULL || !is_there)
            buffer_text(answer, "null");
        else
            add_cell(signals, signal, &moment, answer);
    }
    buffer_text(answer, "]");
}

/* Where the simulator's robots really are: x, y, heading, and whether they touch anything. */
static void add_truth(const struct view *view, size_t k, struct buffer *answer)
{
    const size_t robots = view->recording.truth_size / sizeof(struct truth);
    buffer_text(answer, ",\"truth\":[");
    for (size_t i = 0; i < robots; i++) {
        struct truth truth;
        memcpy(&truth, (const unsigned char *)recording_truth(&view->recording, k) + i * sizeof truth,
               sizeof truth);
        buffer_text(answer, i > 0 ? ",[" : "[");
        buffer_number(answer, truth.x_m);
        buffer_text(answer, ",");
        buffer_number(answer, truth.y_m);
        buffer_text(answer, ",");
        buffer_number(answer, truth.heading_rad);
        buffer_text(answer, truth.touches != 0.0 ? ",1]" : ",0]");
    }
    buffer_text(answer, "]");
}

static void answer_instant(struct view *view, size_t k, struct buffer *answer)
{
    struct moment moment = replay_at(&view->replay, k);
    buffer_format(answer, "{\"is\":\"instant\",\"k\":%lu,\"time\":", (unsigned long)k);
    buffer_number(answer, seconds_at(view, k));
    buffer_text(answer, ",\"dt\":");
    buffer_number(answer, recording_dt(&view->recording, k));
    buffer_text(answer, ",\"cells\":[");
    for (size_t i = 0; i < view->signals.count; i++) {
        const struct signal *signal = &view->signals.all[i];
        buffer_text(answer, i > 0 ? "," : "");
        if (is_known(view, signal))
            add_cell(&view->signals, signal, &moment, answer);
        else
            buffer_text(answer, "\"\"");
    }
    buffer_text(answer, "]");
    if (view->other.is_there)
        add_other_cells(view, k, answer);
    if (view->recording.truth_size > 0)
        add_truth(view, k, answer);
    buffer_text(answer, "}");
}

void view_news(struct view *view, struct buffer *message)
{
    if (!is_live(view)) {
        buffer_text(message, "{\"is\":\"progress\"");
        add_progress(view, message);
    } else {
        buffer_text(message, "{\"is\":\"live\"");
        if (view->recording.count > 0) {
            buffer_text(message, ",\"newest\":");
            answer_instant(view, view->recording.count - 1, message);
        }
        /* After that, for which the program is run up to there. */
        add_extent(view, message);
        add_progress(view, message);
    }
    buffer_text(message, "}");
}

/* The last instant that is not after a time; the first if all are. */
static size_t instant_at(const struct view *view, double seconds)
{
    size_t low = 0, high = view->recording.count;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (seconds_at(view, middle) <= seconds)
            low = middle;
        else
            high = middle;
    }
    return low;
}

struct points {
    const struct view *view;
    const double *numbers;
    const double *other; /* of the edited program; NULL: it has none … */
    size_t other_count;  /* … of further instants */
    struct buffer *times, *values, *others;
};

static void add_point(void *context, size_t k)
{
    struct points *p = (struct points *)context;
    const char *comma = p->times->length > 0 ? "," : "";
    buffer_text(p->times, comma);
    buffer_number(p->times, seconds_at(p->view, k));
    buffer_text(p->values, comma);
    buffer_number(p->values, p->numbers[k]);
    if (p->other != NULL) {
        buffer_text(p->others, comma);
        buffer_number(p->others, k < p->other_count ? p->other[k] : (double)NAN);
    }
}

static const double *other_numbers(struct view *view, const struct signal *signal)
{
    const struct signal *other =
        view->other.is_there ? signals_find(&view->other.signals, signal->name) : NULL;
    return other == NULL ? NULL : series_of(&view->other.series, other);
}

static void answer_series(struct view *view, size_t number, double from, double to, size_t width,
                          struct buffer *answer)
{
    const size_t first = instant_at(view, from), last = instant_at(view, to);
    const size_t end = last + 1 < view->recording.count ? last + 2 : last + 1;
    const struct signal *signal = &view->signals.all[number];
    struct buffer times = { 0 }, values = { 0 }, others = { 0 };
    struct points points = { view, NULL, NULL, 0, &times, &values, &others };
    if (is_known(view, signal)) {
        points.numbers = series_of(&view->series, signal);
        if (points.numbers == NULL) {
            refuse(answer, "not enough memory for this signal's numbers");
            return;
        }
        points.other = other_numbers(view, signal);
        points.other_count = points.other == NULL ? 0 : view->other.replay.recording->count;
        series_visit(points.numbers, first, end, width, add_point, &points);
    }
    buffer_format(answer, "{\"is\":\"series\",\"signal\":%lu,\"from\":", (unsigned long)number);
    buffer_number(answer, from);
    buffer_text(answer, ",\"to\":");
    buffer_number(answer, to);
    buffer_text(answer, ",\"times\":[");
    buffer_text(answer, times.length > 0 ? times.data : "");
    buffer_text(answer, "],\"values\":[");
    buffer_text(answer, values.length > 0 ? values.data : "");
    buffer_text(answer, "]");
    if (points.other != NULL)
        buffer_format(answer, ",\"others\":[%s]", others.length > 0 ? others.data : "");
    buffer_text(answer, "}");
    answer->failed = answer->failed || times.failed || values.failed || others.failed;
    buffer_free(&others);
    buffer_free(&times);
    buffer_free(&values);
}

/* Times and two signals at up to `count` instants. */
static void add_path(const struct recording *recording, const double *xs, const double *ys,
                     size_t count, struct buffer *answer)
{
    const size_t instants = recording->count, points = instants < count ? instants : count;
    buffer_text(answer, "[");
    for (size_t i = 0; i < points; i++) {
        const size_t k = points == 1 ? 0 : i * (instants - 1) / (points - 1);
        buffer_text(answer, i > 0 ? ",[" : "[");
        buffer_number(answer, (double)recording->times[k] / 1e9);
        buffer_text(answer, ",");
        buffer_number(answer, xs[k]);
        buffer_text(answer, ",");
        buffer_number(answer, ys[k]);
        buffer_text(answer, "]");
    }
    buffer_text(answer, "]");
}

static void answer_path(struct view *view, size_t x, size_t y, size_t count,
                        struct buffer *answer)
{
    const struct signal *all = view->signals.all;
    const bool known = is_known(view, &all[x]) && is_known(view, &all[y]);
    const double *xs = !known ? NULL : series_of(&view->series, &all[x]);
    const double *ys = !known ? NULL : series_of(&view->series, &all[y]);
    if (xs == NULL || ys == NULL) {
        refuse(answer, "nothing is known of these signals");
        return;
    }
    buffer_format(answer, "{\"is\":\"path\",\"x\":%lu,\"y\":%lu,\"points\":", (unsigned long)x,
                  (unsigned long)y);
    add_path(&view->recording, xs, ys, count, answer);
    xs = view->other.drives ? other_numbers(view, &all[x]) : NULL;
    ys = xs == NULL ? NULL : other_numbers(view, &all[y]);
    if (ys != NULL) {
        buffer_text(answer, ",\"others\":");
        add_path(&view->other.driven, xs, ys, count, answer);
    }
    buffer_text(answer, "}");
}

static void answer_way(struct view *view, size_t robot, size_t count, struct buffer *answer)
{
    const struct recording *recording = &view->recording;
    const size_t instants = recording->count, points = instants < count ? instants : count;
    buffer_format(answer, "{\"is\":\"way\",\"robot\":%lu,\"points\":[", (unsigned long)robot);
    for (size_t i = 0; i < points; i++) {
        const size_t k = points == 1 ? 0 : i * (instants - 1) / (points - 1);
        struct truth truth;
        memcpy(&truth,
               (const unsigned char *)recording_truth(recording, k) + robot * sizeof truth,
               sizeof truth);
        buffer_text(answer, i > 0 ? ",[" : "[");
        buffer_number(answer, seconds_at(view, k));
        buffer_text(answer, ",");
        buffer_number(answer, truth.x_m);
        buffer_text(answer, ",");
        buffer_number(answer, truth.y_m);
        buffer_text(answer, "]");
    }
    buffer_text(answer, "]}");
}

static void answer_why(struct view *view, size_t k, size_t number, struct buffer *answer)
{
    buffer_format(answer, "{\"is\":\"why\",\"k\":%lu,\"signal\":%lu", (unsigned long)k,
                  (unsigned long)number);
    why_answer(&view->replay, view->origins, &view->signals.all[number], k, answer);
    buffer_text(answer, "}");
}

/* The most spans that are told; a time line has no more pixels. */
#define SPANS 2000

struct findings {
    size_t first, before, after; /* of the instants at which it begins to hold; or … */
    size_t count;
};

static const size_t nowhere = (size_t)-1;

static void add_instant(struct buffer *answer, const char *name, size_t k)
{
    if (k == nowhere)
        buffer_format(answer, ",\"%s\":null", name);
    else
        buffer_format(answer, ",\"%s\":%lu", name, (unsigned long)k);
}

static void answer_find(struct view *view, size_t from, const char *text, struct buffer *answer)
{
    const size_t count = view->recording.count;
    struct findings found = { nowhere, nowhere, nowhere, 0 };
    struct buffer why = { 0 }, spans = { 0 };
    struct condition condition;
    bool held = false;
    if (!condition_read(&condition, &view->series, text, &why)) {
        buffer_text(answer, "{\"is\":\"found\",\"why\":");
        buffer_string(answer, why.length > 0 ? why.data : "");
        buffer_text(answer, "}");
    } else {
        for (size_t k = 0; k < count; k++) {
            bool holds = condition_holds(&condition, k);
            if (holds && !held) {
                found.count++;
                found.first = found.first == nowhere ? k : found.first;
                found.before = k < from ? k : found.before;
                found.after = k > from && found.after == nowhere ? k : found.after;
            }
            if (holds != held && found.count <= SPANS) {
                buffer_text(&spans, spans.length == 0 ? "" : ",");
                buffer_number(&spans, seconds_at(view, k));
            }
            held = holds;
        }
        buffer_format(answer, "{\"is\":\"found\",\"count\":%lu", (unsigned long)found.count);
        add_instant(answer, "first", found.first);
        add_instant(answer, "before", found.before);
        add_instant(answer, "after", found.after);
        /* From and to, in turn; what holds to the end has no end. */
        buffer_format(answer, ",\"spans\":[%s]}", spans.length > 0 ? spans.data : "");
    }
    answer->failed = answer->failed || spans.failed;
    condition_free(&condition);
    buffer_free(&why);
    buffer_free(&spans);
}

static bool can_try(const struct view *view, bool drives)
{
    const struct view_files *files = view->files;
    return files->commands.build != NULL && files->own_count > 0 && view->replay.runs &&
           (!drives || (files->commands.drive != NULL && !is_live(view)));
}

static void answer_what_if(struct view *view, const char *text, bool drives,
                           struct buffer *answer)
{
    struct buffer why = { 0 };
    if (*text == '\0') {
        what_if_end(&view->other);
        buffer_text(answer, "{\"is\":\"what-if\",\"there\":false}");
    } else if (!can_try(view, drives)) {
        refuse(answer, drives ? "this run cannot be driven again"
                              : "this program cannot be run again on the recording");
    } else if (!what_if_start(&view->other, &view->signals, &view->recording,
                              &view->files->commands, view->files->sources[0], text, drives,
                              &why)) {
        buffer_text(answer, "{\"is\":\"what-if\",\"there\":false,\"why\":");
        buffer_string(answer, why.length > 0 ? why.data : "");
        buffer_text(answer, "}");
    } else {
        buffer_format(answer, "{\"is\":\"what-if\",\"there\":true,\"drives\":%s",
                      drives ? "true" : "false");
        if (view->other.first_in != NULL) {
            buffer_format(answer, ",\"first\":%lu,\"signal\":",
                          (unsigned long)view->other.first);
            buffer_string(answer, view->other.first_in->name);
        }
        buffer_text(answer, "}");
    }
    buffer_free(&why);
}

/* {1 Requests} */

/* Takes one word and the blank before it off a request, as a number below `limit`. */
static bool take_number(const char **at, size_t limit, size_t *result)
{
    char *end;
    unsigned long long number;
    if (**at != ' ' || (*at)[1] < '0' || (*at)[1] > '9')
        return false;
    errno = 0;
    number = strtoull(*at + 1, &end, 10);
    if (errno != 0 || number >= limit)
        return false;
    *at = end;
    *result = (size_t)number;
    return true;
}

static bool take_word(const char **at, const char *word)
{
    size_t length = strlen(word);
    if (strncmp(*at, word, length) != 0 || ((*at)[length] != '\0' && (*at)[length] != ' '))
        return false;
    *at += length;
    return true;
}

static bool take_seconds(const char **at, double *result)
{
    char *end;
    if (**at != ' ')
        return false;
    *result = strtod(*at + 1, &end);
    if (end == *at + 1 || !isfinite(*result))
        return false;
    *at = end;
    return true;
}

void view_answer(struct view *view, const char *request, struct buffer *answer)
{
    const size_t count = view->recording.count;
    const char *at = request;
    size_t k, signal, other, width;
    double seconds, from, to;
    if (take_word(&at, "program") && *at == '\0')
        answer_program(view, answer);
    else if (count == 0)
        refuse(answer, "there is no instant yet");
    else if (take_word(&at, "instant") && take_number(&at, count, &k) && *at == '\0')
        answer_instant(view, k, answer);
    else if (take_word(&at, "time") && take_seconds(&at, &seconds) && *at == '\0')
        answer_instant(view, instant_at(view, seconds), answer);
    else if (take_word(&at, "series") && take_number(&at, view->signals.count, &signal) &&
             take_seconds(&at, &from) && take_seconds(&at, &to) &&
             take_number(&at, 100001, &width) && *at == '\0' && from <= to)
        answer_series(view, signal, from, to, width, answer);
    else if (take_word(&at, "path") && take_number(&at, view->signals.count, &signal) &&
             take_number(&at, view->signals.count, &other) && take_number(&at, 100001, &width) &&
             *at == '\0')
        answer_path(view, signal, other, width, answer);
    else if (take_word(&at, "way") &&
             take_number(&at, view->recording.truth_size / sizeof(struct truth), &signal) &&
             take_number(&at, 100001, &width) && *at == '\0')
        answer_way(view, signal, width, answer);
    else if (take_word(&at, "why") && take_number(&at, count, &k) &&
             take_number(&at, view->signals.count, &signal) && *at == '\0' &&
             is_known(view, &view->signals.all[signal]))
        answer_why(view, k, signal, answer);
    else if (take_word(&at, "find") && take_number(&at, count, &k) && *at == ' ')
        answer_find(view, k, at + 1, answer);
    else if (take_word(&at, "what-if") && (*at == ' ' || *at == '\0'))
        answer_what_if(view, *at == ' ' ? at + 1 : at, false, answer);
    else if (take_word(&at, "drive") && *at == ' ')
        answer_what_if(view, at + 1, true, answer);
    else
        refuse(answer, "this is no request");
    if (answer->failed) {
        buffer_clear(answer);
        refuse(answer, "not enough memory for the answer");
    }
}
