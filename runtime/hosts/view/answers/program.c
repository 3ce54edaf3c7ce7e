#include "answers.h"

#include "../console_kinds.h"
#include "kept.h"

static const char *kind_of(const struct signal *signal)
{
    if (signal->side == MODE)
        return "mode";
    switch (signal->shown->kind) {
    case FROB_BOOL: return "bool";
    case FROB_INT: return "int";
    case FROB_FLOAT:
    case FROB_SINGLE:
    case FROB_ROUNDED: return "float";
    case FROB_SUM: return signal->shown->is_event ? "event" : "sum";
    case FROB_PRODUCT:
    case FROB_ARRAY:
    case FROB_IMAGE: break;
    }
    return "data";
}

/* Appends the names that the numbers in a plot represent. */
static void add_names(const struct view *view, const struct signal *signal, struct buffer *answer)
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

/* Appends the signal's description from the table of columns. */
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

/* Appends the transitions of a machine. Each has the numbers of both modes, and the event that
 * triggers the transition. */
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

/* Returns whether an inner signal is independent of all other signals, and therefore constant
 * unless it depends on the time or a mode. */
static bool is_fixed(const struct view *view, const struct signal *signal)
{
    const struct frob_origin *origin = why_origin(view->origins, signal);
    return signal->side == PROBE && origin != NULL && origin->transitions == NULL &&
           (origin->sources == NULL || origin->sources->column == NULL);
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
        buffer_format(answer, ",\"fixed\":%s", is_fixed(view, signal) ? "true" : "false");
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

/* Appends the members of `program` that change while the program is run over the recording. */
void answer_progress(const struct view *view, struct buffer *message)
{
    struct buffer summary = { 0 };
    view_summary(view, &summary);
    buffer_format(message, ",\"replayed\":%lu,\"notes\":",
                  (unsigned long)(view->replay.runs ? view->replay.reached : 0));
    buffer_string(message, summary.length > 0 ? summary.data : "");
    buffer_free(&summary);
}

/* Appends the members that grow in a live run. */
void answer_extent(const struct view *view, struct buffer *message)
{
    const size_t count = view->recording.count;
    buffer_format(message, ",\"instants\":%lu,\"start\":", (unsigned long)count);
    buffer_number(message, count == 0 ? 0.0 : view_seconds_at(view, 0));
    buffer_text(message, ",\"end\":");
    buffer_number(message, count == 0 ? 0.0 : view_seconds_at(view, count - 1));
    buffer_format(message, ",\"live\":%s",
                  view_is_live(view) && !view->live.has_ended ? "true" : "false");
}

static bool has_outputs(const struct view *view)
{
    for (size_t i = 0; i < view->signals.count; i++)
        if (view->signals.all[i].side == OUTPUT && view->recording.recorded[i])
            return true;
    return false;
}

static const char *console_kind(enum frob_control_kind kind)
{
    switch (kind) {
#define KIND(value, name) \
    case value: return name;
        CONSOLE_KINDS(KIND)
#undef KIND
    }
    return "unknown";
}

/* Appends the controls on the console, in the order of their numbers, each with its signal. */
static void add_console(const struct view *view, struct buffer *answer)
{
    buffer_text(answer, ",\"console\":[");
    for (size_t i = 0; i < view->program->control_count; i++) {
        const struct frob_control *control = &view->program->console[i];
        size_t signal = 0;
        while (signal < view->signals.count && view->signals.all[signal].value != control->value)
            signal++;
        buffer_format(answer, "%s{\"kind\":\"%s\",\"label\":", i > 0 ? "," : "",
                      console_kind(control->kind));
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

static void add_setting(const struct frob_param *param, const void *values, const char *name,
                        struct buffer *answer)
{
    char room[200];
    struct frob_text text = frob_text_in(room, sizeof room);
    params_write(&text, param, values);
    buffer_format(answer, ",\"%s\":", name);
    buffer_string(answer, room);
}

/* Appends each parameter with its value in this run and its default. */
static void add_params(const struct view *view, struct buffer *answer)
{
    const size_t count = view->replay.runs ? view->program->param_count : 0;
    buffer_text(answer, ",\"params\":[");
    for (size_t i = 0; i < count; i++) {
        const struct frob_param *param = &view->program->params[i];
        buffer_text(answer, i > 0 ? ",{\"name\":" : "{\"name\":");
        buffer_string(answer, param->name);
        buffer_text(answer, ",\"unit\":");
        buffer_string(answer, param->unit);
        add_setting(param, view->replay.params.values, "value", answer);
        add_setting(param, view->program->default_params, "first", answer);
        buffer_text(answer, "}");
    }
    buffer_text(answer, "]");
}

void answer_program(struct view *view, struct buffer *answer)
{
    struct buffer kept = { 0 };
    buffer_text(answer, "{\"is\":\"program\",\"name\":");
    buffer_string(answer, view->program->name);
    buffer_text(answer, ",\"robot\":");
    buffer_string(answer, view->program->robot);
    buffer_text(answer, ",\"recording\":");
    buffer_string(answer, view_is_live(view) ? "" : view_without_folder(view->recording.name));
    answer_extent(view, answer);
    buffer_text(answer, ",\"at\":");
    buffer_number(answer, view_start_time(view));
    buffer_format(answer, ",\"runs\":%s,\"compared\":%s", view->replay.runs ? "true" : "false",
                  has_outputs(view) ? "true" : "false");
    answer_progress(view, answer);
    buffer_format(answer, ",\"sees\":%s", view->recording.eye_count > 0 ? "true" : "false");
    add_signals(view, answer);
    add_console(view, answer);
    add_params(view, answer);
    buffer_text(answer, ",\"sources\":[");
    for (size_t i = 0; i < view->source_count; i++) {
        buffer_text(answer, i > 0 ? "," : "");
        add_source(&view->sources[i], answer);
    }
    buffer_text(answer, "],\"world\":");
    add_source(&view->world, answer);
    kept_read(view->files->own_count > 0 ? view->files->sources[0] : NULL, &kept);
    answer_other(view, answer);
    buffer_text(answer, ",\"kept\":");
    buffer_string(answer, kept.length > 0 ? kept.data : "");
    buffer_free(&kept);
    buffer_text(answer, "}");
}
