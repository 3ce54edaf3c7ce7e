#include "answers.h"

#include "../../common/truth.h"

#include <math.h>
#include <string.h>

static void add_cell(const struct signals *signals, const struct signal *signal,
                     const struct moment *moment, struct buffer *answer)
{
    struct buffer cell = { 0 };
    signal_write(signals, signal, moment, &cell);
    buffer_string(answer, cell.length > 0 ? cell.data : "");
    buffer_free(&cell);
}

/* Appends the cells of the edited program, in the order of the original program's signals; null for
 * signals that the edited program does not have. */
static void add_other_cells(struct view *view, size_t k, struct buffer *answer)
{
    const struct signals *signals = &view->other.signals;
    size_t there;
    const bool is_there = compare_instant(&view->other, &view->recording, k, &there);
    struct moment moment = { NULL, NULL, NULL };
    if (is_there)
        moment = replay_at(&view->other.replay, there);
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

/* Appends the true state of the simulator's robots: x, y, heading, and whether they touch anything;
 * and the true poses of objects that can move. */
static void add_truth(const struct view *view, size_t k, struct buffer *answer)
{
    const size_t count = view->recording.truth_size / sizeof(struct truth);
    bool is_object = false;
    buffer_text(answer, ",\"truth\":[");
    for (size_t i = 0; i < count; i++) {
        struct truth truth;
        const char *separator = i > 0 ? ",[" : "[";
        memcpy(&truth,
               (const unsigned char *)recording_truth(&view->recording, k) + i * sizeof truth,
               sizeof truth);
        if (truth.touches == TRUTH_OBJECT && !is_object) {
            is_object = true;
            separator = "],\"objects\":[[";
        }
        buffer_text(answer, separator);
        buffer_number(answer, truth.x_m);
        buffer_text(answer, ",");
        buffer_number(answer, truth.y_m);
        buffer_text(answer, ",");
        buffer_number(answer, truth.heading_rad);
        buffer_text(answer, is_object ? "]" : truth.touches != 0.0 ? ",1]" : ",0]");
    }
    buffer_text(answer, "]");
}

/* How long an event of the input stays visible, in ns. One cycle of all sonars takes 320 ms. */
#define RECENT_NS 400000000

/* Appends the position and heading of the first robot: the true ones if they are known, otherwise
 * those from odometry. */
static void add_pose(struct view *view, size_t k, struct buffer *answer)
{
    static const char *const names[] = { "in.odometry.position.x", "in.odometry.position.y",
                                         "in.odometry.heading" };
    const struct moment moment = { recording_input(&view->recording, k), NULL, NULL };
    if (view->recording.truth_size > 0) {
        struct truth truth;
        memcpy(&truth, recording_truth(&view->recording, k), sizeof truth);
        buffer_text(answer, ",");
        buffer_number(answer, truth.x_m);
        buffer_text(answer, ",");
        buffer_number(answer, truth.y_m);
        buffer_text(answer, ",");
        buffer_number(answer, truth.heading_rad);
        return;
    }
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        const struct signal *signal = signals_find(&view->signals, names[i]);
        buffer_text(answer, ",");
        if (signal == NULL)
            buffer_text(answer, "null");
        else
            buffer_number(answer, signal_number(&view->signals, signal, &moment));
    }
}

/* Finds the last instant up to `k` at which an event of the input occurred. Returns false if the
 * event has not occurred recently. */
static bool find_recent(const struct view *view, const struct signal *signal, size_t k,
                        size_t *found)
{
    const struct recording *recording = &view->recording;
    for (size_t i = k + 1; i-- > 0 && recording->times[k] - recording->times[i] < RECENT_NS;) {
        const struct moment moment = { recording_input(recording, i), NULL, NULL };
        if (!isnan(signal_number(&view->signals, signal, &moment))) {
            *found = i;
            return true;
        }
    }
    return false;
}

/* Returns whether the value of an event is a record, such as a lidar's scan. */
static bool carries_record(const struct signal *signal)
{
    return signal->shown->constructors[1].fields[0].value->kind == FROB_PRODUCT;
}

/* Appends each recent event of the input that carries a value, such as an echo, with the number of
 * its signal, the value as a number, and the robot's pose at that time. If the value is a record,
 * also appends its cell. */
static void add_recent(struct view *view, size_t k, struct buffer *answer)
{
    const char *comma = "";
    buffer_text(answer, ",\"recent\":[");
    for (size_t i = 0; i < view->signals.count; i++) {
        const struct signal *signal = &view->signals.all[i];
        size_t at;
        if (signal->side != INPUT || signal->shown->kind != FROB_SUM || !signal->shown->is_event ||
            !find_recent(view, signal, k, &at))
            continue;
        {
            const struct moment moment = { recording_input(&view->recording, at), NULL, NULL };
            buffer_format(answer, "%s[%lu,", comma, (unsigned long)i);
            buffer_number(answer, signal_number(&view->signals, signal, &moment));
            add_pose(view, at, answer);
            if (carries_record(signal)) {
                buffer_text(answer, ",");
                add_cell(&view->signals, signal, &moment, answer);
            }
            buffer_text(answer, "]");
            comma = ",";
        }
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
    add_recent(view, k, answer);
    buffer_text(answer, "}");
}
