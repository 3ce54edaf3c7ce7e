#include "touches.h"

#include <frob/console.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static int64_t clock_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * 1000000000 + now.tv_nsec;
}

bool touches_start(struct touches *t, const struct frob_program *program)
{
    memset(t, 0, sizeof *t);
    t->program = program;
    t->key = -1;
    t->held_until_ns = (int64_t *)calloc(program->control_count + 1, sizeof *t->held_until_ns);
    if (t->held_until_ns == NULL)
        fprintf(stderr, "error: not enough memory for the console\n");
    return t->held_until_ns != NULL;
}

void touches_end(struct touches *t)
{
    free(t->held_until_ns);
    t->held_until_ns = NULL;
}

static void add(struct touches *t, size_t control, double x, double y)
{
    const struct touch touch = { control, x, y };
    if (t->count < sizeof t->list / sizeof t->list[0])
        t->list[t->count++] = touch;
}

static bool is_touched(const struct touches *t, size_t control)
{
    for (size_t i = 0; i < t->count; i++)
        if (t->list[i].control == control)
            return true;
    return false;
}

/* Handles a held button. The page repeats this event, with a timestamp. An event that was delayed
 * for too long is ignored. */
static void hold(struct touches *t, size_t control, double x, double at_s, int64_t now_ns)
{
    const double age_s = (double)now_ns / 1e9 - at_s;
    const bool is_held = x > 0.0 && age_s >= 0.0 && age_s < (double)TOUCHES_HELD_NS / 1e9;
    if (is_held)
        t->held_until_ns[control] = now_ns + TOUCHES_HELD_NS - (int64_t)(age_s * 1e9);
    if (is_held || x <= 0.0)
        add(t, control, is_held, 0.0);
    if (x <= 0.0)
        t->held_until_ns[control] = 0;
}

/* Takes an event. Returns false if it must wait for the next instant. */
static bool take(struct touches *t, const struct ring_event *event, int64_t now_ns)
{
    const struct frob_control *control;
    if (event->kind == RING_KEY && event->id <= INT32_MAX) {
        if (t->key >= 0)
            return false;
        t->key = (int32_t)event->id;
        return true;
    }
    if ((event->kind != RING_TOUCH && event->kind != RING_HOLD) ||
        event->id >= t->program->control_count || !isfinite(event->x) || !isfinite(event->y))
        return true; /* ignore invalid events */
    control = &t->program->console[event->id];
    if ((control->kind == FROB_HOLD) != (event->kind == RING_HOLD))
        return true;
    if (control->kind == FROB_HOLD) {
        hold(t, event->id, event->x, event->y, now_ns);
        return true;
    }
    if ((control->kind == FROB_BUTTON || control->kind == FROB_MAP) && is_touched(t, event->id))
        return false;
    add(t, event->id, event->x, event->y);
    return true;
}

static void let_go(struct touches *t, int64_t now_ns)
{
    for (size_t i = 0; i < t->program->control_count; i++) {
        if (t->held_until_ns[i] != 0 && now_ns > t->held_until_ns[i]) {
            t->held_until_ns[i] = 0;
            add(t, i, 0.0, 0.0);
        }
    }
}

void touches_take(struct touches *t, struct console *console, struct ring *ring)
{
    const int64_t now_ns = clock_ns();
    ring_show_alive(ring); /* drops stale events */
    t->key = console_key(console);
    t->count = 0;
    if (t->has_waiting && t->freezes != ring->freezes) {
        t->has_waiting = false;
        ring_drop_late(ring);
    }
    t->freezes = ring->freezes;
    if (t->has_waiting)
        t->has_waiting = !take(t, &t->waiting, now_ns);
    for (size_t i = 0; i < RING_EVENTS && !t->has_waiting && ring_take(ring, &t->waiting); i++)
        t->has_waiting = !take(t, &t->waiting, now_ns);
    let_go(t, now_ns);
}

void touches_apply(const struct touches *t, void *input)
{
    frob_console_key(t->program, input, t->key);
    for (size_t i = 0; i < t->count; i++)
        frob_console_touch(t->program, input, t->list[i].control, t->list[i].x, t->list[i].y);
}
