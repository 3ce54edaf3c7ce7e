#include "answers.h"

#include "condition.h"

/* Maximum number of reported spans. A timeline is at most this many pixels wide. */
#define SPANS 2000

struct findings {
    size_t first, before, after; /* instants at which the condition becomes true, or `nowhere` */
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

void answer_find(struct view *view, size_t from, const char *text, struct buffer *answer)
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
            bool holds = condition_holds(&condition, k, view_seconds_at(view, k));
            if (holds && !held) {
                found.count++;
                found.first = found.first == nowhere ? k : found.first;
                found.before = k < from ? k : found.before;
                found.after = k > from && found.after == nowhere ? k : found.after;
            }
            if (holds != held && found.count <= SPANS) {
                buffer_text(&spans, spans.length == 0 ? "" : ",");
                buffer_number(&spans, view_seconds_at(view, k));
            }
            held = holds;
        }
        buffer_format(answer, "{\"is\":\"found\",\"count\":%lu", (unsigned long)found.count);
        add_instant(answer, "first", found.first);
        add_instant(answer, "before", found.before);
        add_instant(answer, "after", found.after);
        /* The times alternate between starts and ends. A span that lasts until the end of the run
         * has no end. */
        buffer_format(answer, ",\"spans\":[%s]}", spans.length > 0 ? spans.data : "");
    }
    answer->failed = answer->failed || spans.failed;
    condition_free(&condition);
    buffer_free(&why);
    buffer_free(&spans);
}
