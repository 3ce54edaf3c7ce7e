#include "answers.h"

#include <math.h>

struct points {
    const struct view *view;
    const double *numbers;
    const double *other; /* values of the edited program's signal; NULL if it does not
                          * have this signal */
    struct buffer *times, *values, *others;
};

static void add_point(void *context, size_t k)
{
    struct points *p = (struct points *)context;
    const char *comma = p->times->length > 0 ? "," : "";
    buffer_text(p->times, comma);
    buffer_number(p->times, view_seconds_at(p->view, k));
    buffer_text(p->values, comma);
    buffer_number(p->values, p->numbers[k]);
    if (p->other != NULL) {
        size_t there;
        const bool is_there = compare_instant(&p->view->other, &p->view->recording, k, &there);
        buffer_text(p->others, comma);
        buffer_number(p->others, is_there ? p->other[there] : (double)NAN);
    }
}

const double *view_other_numbers(struct view *view, const struct signal *signal)
{
    const struct signal *other =
        view->other.is_there ? signals_find(&view->other.signals, signal->name) : NULL;
    return other == NULL ? NULL : series_of(&view->other.series, other);
}

void answer_series(struct view *view, size_t number, double from, double to, size_t width,
                   struct buffer *answer)
{
    const size_t first = view_instant_at(view, from), last = view_instant_at(view, to);
    const size_t end = last + 1 < view->recording.count ? last + 2 : last + 1;
    const struct signal *signal = &view->signals.all[number];
    struct buffer times = { 0 }, values = { 0 }, others = { 0 };
    struct points points = { view, NULL, NULL, &times, &values, &others };
    if (view_knows(view, signal)) {
        points.numbers = series_of(&view->series, signal);
        if (points.numbers == NULL) {
            answer_refusal(answer, "not enough memory for this signal's numbers");
            return;
        }
        points.other = view_other_numbers(view, signal);
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
