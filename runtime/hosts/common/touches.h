/* touches.h -- the operator's input at an instant: a key, and touches of controls on the program's
 * console.
 *
 * A button and the map have at most one event in an instant; a second one waits for the next
 * instant, and so do all events after it. A held button must be reported repeatedly: it is released
 * if its page, the connection or the viewer is silent for 0.3 s.
 *
 * If the host freezes while an event waits, the event becomes stale. It is dropped and counted as
 * late, like stale events in the ring. */
#ifndef FROB_HOST_TOUCHES_H
#define FROB_HOST_TOUCHES_H

#include "console.h"
#include "ring.h"

#include <frob/program.h>

#define TOUCHES_HELD_NS INT64_C(300000000)

struct touch {
    size_t control;
    double x, y;
};

struct touches {
    const struct frob_program *program;
    int32_t key; /* -1: none */
    size_t count;
    struct touch list[RING_EVENTS + 1];
    int64_t *held_until_ns;    /* for each control, the CLOCK_MONOTONIC time until which it is held;
                                * 0: not held */
    struct ring_event waiting; /* an event that waits for the next instant */
    bool has_waiting;          /* whether `waiting` is valid */
    uint32_t freezes;          /* the ring's `freezes` when the event was taken */
};

/* Returns false and prints a line on standard error if memory runs out. */
bool touches_start(struct touches *touches, const struct frob_program *program);

/* Collects the touches of the next instant, from the terminal and from viewers. Does not wait. */
void touches_take(struct touches *touches, struct console *console, struct ring *ring);

/* Applies the touches to an input. */
void touches_apply(const struct touches *touches, void *input);

void touches_end(struct touches *touches);

#endif
