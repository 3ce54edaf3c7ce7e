#include "answers.h"

#include "../../common/truth.h"

#include <string.h>

static void add_cell(const struct signals *signals, const struct signal *signal,
                     const struct moment *moment, struct buffer *answer)
{
    struct buffer cell = { 0 };
    signal_write(signals, signal, moment, &cell);
    buffer_string(answer, cell.length > 0 ? cell.data : "");
    buffer_free(&cell);
}

/* Appends the cells of the edited program, in the same order; null for signals that it does not
 * have. */
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

/* Appends the true state of the simulator's robots: x, y, heading, and whether they touch
 * anything. */
static void add_truth(const struct view *view, size_t k, struct buffer *answer)
{
    const size_t robots = view->recording.truth_size / sizeof(struct truth);
    buffer_text(answer, ",\"truth\":[");
    for (size_t i = 0; i < robots; i++) {
        struct truth truth;
        memcpy(&truth,
               (const unsigned char *)recording_truth(&view->recording, k) + i * sizeof truth,
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

void answer_instant(struct view *view, size_t k, struct buffer *answer)
{
    struct moment moment = replay_at(&view->replay, k);
    buffer_format(answer, "{\"is\":\"instant\",\"k\":%lu,\"time\":", (unsigned long)k);
    buffer_number(answer, view_seconds_at(view, k));
    buffer_text(answer, ",\"dt\":");
    buffer_number(answer, (double)recording_dt_ns(&view->recording, k) / 1e9);
    buffer_text(answer, ",\"cells\":[");
    for (size_t i = 0; i < view->signals.count; i++) {
        const struct signal *signal = &view->signals.all[i];
        buffer_text(answer, i > 0 ? "," : "");
        if (view_knows(view, signal))
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
