/* touches.h -- what the operator does at an instant: a key, and what is touched on the console
 * of the program.
 *
 * A button and the map have one event in an instant; a second one waits for the next, and so
 * does what came after it. A button that is held has to be heard of again and again: it is let
 * go of 0.3 s after its page, the line to it or the viewer has fallen silent. */
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
    int64_t *held_until_ns;    /* of each control, on the machine's clock; 0: not held */
    struct ring_event waiting; /* for the next instant … */
    bool has_waiting;          /* … if there is one */
};

/* False without memory, with a line on standard error. */
bool touches_start(struct touches *touches, const struct frob_program *program);

/* Those of the next instant, from the terminal and from who looks on. Does not wait. */
void touches_take(struct touches *touches, struct console *console, struct ring *ring);

/* As part of an input. */
void touches_apply(const struct touches *touches, void *input);

void touches_end(struct touches *touches);

#endif
