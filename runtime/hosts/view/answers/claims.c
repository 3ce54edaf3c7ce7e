#include "answers.h"

#include <string.h>

/* Maximum number of reported times at which an assertion is violated. A timeline is at most this
 * many pixels wide. */
#define TIMES 2000

static void add_fate(const struct claims *claims, size_t i, struct buffer *answer)
{
    const struct claim_state *state = &claims->each[i];
    char fate[CLAIMS_FATE];
    claims_fate(claims, i, fate);
    buffer_format(answer, "{\"failed\":%s,\"asked\":%s,\"open\":%s,\"text\":",
                  state->failed > 0 ? "true" : "false", state->asked > 0 ? "true" : "false",
                  state->last == VERDICT_OPEN ? "true" : "false");
    buffer_string(answer, fate);
    buffer_text(answer, "}");
}

/* Appends the number of the signal that contains the assertion's verdict. For an assertion in
 * `mapSF`, which has many verdicts, appends -1. */
static void add_signal(const struct view *view, const struct frob_claim *claim,
                       struct buffer *answer)
{
    struct buffer name = { 0 };
    const struct signal *signal;
    buffer_format(&name, "probe.%s", claim->column);
    signal = name.failed ? NULL : signals_find(&view->signals, name.data);
    buffer_format(answer, ",\"signal\":%ld",
                  signal == NULL ? -1L : (long)(signal - view->signals.all));
    buffer_free(&name);
}

static void add_times(const struct view *view, const struct watched *watched, struct buffer *answer)
{
    buffer_text(answer, ",\"times\":[");
    for (size_t i = 0; i < watched->count && i < 2 * TIMES; i++) {
        buffer_text(answer, i > 0 ? "," : "");
        buffer_number(answer, view_seconds_at(view, watched->ends[i]));
    }
    buffer_text(answer, "]");
}

/* Appends the result of the same assertion (the one with the same column) in the edited program;
 * null if there is none. */
static void add_other(const struct view *view, const struct frob_claim *claim,
                      struct buffer *answer)
{
    const struct claims *others = &view->other.replay.watch.claims;
    buffer_text(answer, ",\"other\":");
    for (size_t i = 0; i < others->program->claim_count; i++)
        if (strcmp(others->program->claims[i].column, claim->column) == 0) {
            add_fate(others, i, answer);
            return;
        }
    buffer_text(answer, "null");
}

void answer_claims(const struct view *view, struct buffer *answer)
{
    const struct watch *watch = &view->replay.watch;
    const size_t count = view->replay.runs ? view->program->claim_count : 0;
    buffer_text(answer, "{\"is\":\"claims\",\"all\":[");
    for (size_t i = 0; i < count; i++) {
        const struct frob_claim *claim = &view->program->claims[i];
        buffer_text(answer, i > 0 ? ",{\"label\":" : "{\"label\":");
        buffer_string(answer, claim->label);
        buffer_text(answer, ",\"column\":");
        buffer_string(answer, claim->column);
        buffer_text(answer, ",\"place\":");
        buffer_string(answer, claim->place);
        buffer_format(answer, ",\"assumed\":%s", claim->is_assumption ? "true" : "false");
        add_signal(view, claim, answer);
        buffer_text(answer, ",\"fate\":");
        add_fate(&watch->claims, i, answer);
        add_times(view, &watch->each[i], answer);
        if (view->other.is_there && view->other.replay.runs)
            add_other(view, claim, answer);
        buffer_text(answer, "}");
    }
    buffer_text(answer, "]}");
}
