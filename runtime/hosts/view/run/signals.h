/* signals.h -- all signals of a program at an instant: the parts of its input and output, its inner
 * signals, and the modes of its machines. */
#ifndef FROB_VIEW_SIGNALS_H
#define FROB_VIEW_SIGNALS_H

#include "../buffer.h"

#include <frob/columns.h>
#include <frob/program.h>

#include <stdbool.h>
#include <stdint.h>

enum side { INPUT, OUTPUT, PROBE, MODE };

struct signal {
    char *name; /* its column in a trace */
    enum side side;
    const struct frob_value *value; /* NULL for a mode */
    /* For a probe that may be absent, the value that it has when present; otherwise the same as
     * `value`. */
    const struct frob_value *shown;
    size_t machine;                   /* for a mode: index of its machine */
    const struct frob_column *column; /* description of the signal; NULL if there is none */
    const char *below;                /* the part of the name after the column's name */
};

struct signals {
    const struct frob_program *program;
    struct signal *all;
    size_t count, capacity;
    bool no_memory;
};

/* The data of an instant. If `state` is NULL, inner signals and modes are unknown. */
struct moment {
    const void *input, *output, *state;
};

/* Collects all signals of a program. `columns` may be NULL. Returns false if memory runs out. */
bool signals_start(struct signals *signals, const struct frob_program *program,
                   const struct frob_column *columns);
void signals_end(struct signals *signals);

/* Returns the size in bytes of the program's output in the output struct; the inner signals follow
 * the output. */
size_t signals_output_size(const struct signals *signals);

/* Returns the signal with this name; NULL if there is none. */
const struct signal *signals_find(const struct signals *signals, const char *name);

/* Returns whether the signal is the running mode of a machine. */
bool signal_is_mode(const struct signal *signal);

/* Writes the signal's value as a cell of a trace. */
void signal_write(const struct signals *signals, const struct signal *signal,
                  const struct moment *moment, struct buffer *text);

/* Returns the signal's value as a number for a plot: a truth value as 0 or 1, a constructor as its
 * index in the type, and an event that occurs as its value, or as 1 if its value is not a number.
 * Returns NAN if there is no value, because an event does not occur or because a mode's machine
 * does not exist. */
double signal_number(const struct signals *signals, const struct signal *signal,
                     const struct moment *moment);

/* Returns whether two values look the same in a trace. They do if they are equal bit for bit, or if
 * both are NaN. */
bool signal_values_equal(const struct frob_value *value, const void *a, const void *b);

#endif
