/* The recording to compare with: its alignment in time, and where it differs. */
#include "answers.h"

#include "condition.h"

#include <string.h>

static const size_t nowhere = (size_t)-1;

/* Finds the first instant at which a condition holds. Returns false if the condition is invalid. */
static bool find_first(struct series *series, const char *text, const struct recording *recording,
                       size_t *first, struct buffer *why)
{
    struct condition condition;
    const bool is_valid = condition_read(&condition, series, text, why);
    *first = nowhere;
    for (size_t k = 0; is_valid && *first == nowhere && k < recording->count; k++)
        if (condition_holds(&condition, k, (double)recording->times[k] / 1e9))
            *first = k;
    condition_free(&condition);
    return is_valid;
}

/* Computes the shift for a condition. Returns false, with the reason, if there is none. */
static bool find_shift(struct view *view, const char *condition, int64_t *shift, struct buffer *why)
{
    const struct recording *here = &view->recording, *there = view->other.replay.recording;
    size_t a = 0, b = 0;
    if (*condition != '\0') {
        if (!find_first(&view->series, condition, here, &a, why) ||
            !find_first(&view->other.series, condition, there, &b, why))
            return false;
        if (a == nowhere || b == nowhere) {
            buffer_format(why, "never true in %s",
                          view_without_folder(a == nowhere ? here->name : there->name));
            return false;
        }
    }
    *shift = there->times[b] - here->times[a];
    return true;
}

static bool has_setting(const struct buffer *settings, const char *setting)
{
    for (size_t at = 0; at < settings->length; at += strlen(settings->data + at) + 1)
        if (strcmp(settings->data + at, setting) == 0)
            return true;
    return false;
}

/* Appends the parameters of the other recording that have different values in this one. */
static void add_settings(const struct view *view, struct buffer *answer)
{
    const struct buffer *here = &view->recording.params, *there = &view->other.driven.params;
    const char *comma = "";
    buffer_text(answer, ",\"set\":[");
    for (size_t at = 0; at < there->length; at += strlen(there->data + at) + 1) {
        if (has_setting(here, there->data + at))
            continue;
        buffer_text(answer, comma);
        buffer_string(answer, there->data + at);
        comma = ",";
    }
    buffer_text(answer, "]");
}

void answer_other(const struct view *view, struct buffer *answer)
{
    const struct what_if *other = &view->other;
    if (!other->compares)
        return;
    buffer_text(answer, ",\"other\":{\"name\":");
    buffer_string(answer, view_without_folder(other->driven.name));
    buffer_format(answer, ",\"runs\":%s,\"shift\":", other->replay.runs ? "true" : "false");
    buffer_number(answer, (double)other->shift_ns / 1e9);
    add_settings(view, answer);
    if (other->first_in != NULL) {
        buffer_format(answer, ",\"first\":%lu,\"signal\":", (unsigned long)other->first);
        buffer_string(answer, other->first_in->name);
    }
    buffer_text(answer, "}");
}

void answer_align(struct view *view, const char *condition, struct buffer *answer)
{
    struct buffer why = { 0 };
    buffer_text(answer, "{\"is\":\"align\"");
    if (!view->other.compares)
        buffer_text(answer, ",\"why\":\"there is no recording to compare with\"");
    else if (find_shift(view, condition, &view->other.shift_ns, &why))
        compare_find_difference(&view->other, &view->recording);
    if (why.length > 0) {
        buffer_text(answer, ",\"why\":");
        buffer_string(answer, why.data);
    }
    answer_other(view, answer);
    buffer_text(answer, "}");
    buffer_free(&why);
}
