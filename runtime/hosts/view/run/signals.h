/* signals.h -- what a program has to show at an instant: the parts of its input
 * and output, its inner signals, and the modes of its machines. */
#ifndef FROB_VIEW_SIGNALS_H
#define FROB_VIEW_SIGNALS_H

#include "../buffer.h"

#include <frob/columns.h>
#include <frob/program.h>

#include <stdbool.h>
#include <stdint.h>

enum side { INPUT, OUTPUT, PROBE, MODE };

struct signal {
    char *name; /* as the column of a trace */
    enum side side;
    const struct frob_value *value;   /* but of a mode */
    const struct frob_value *shown;   /* likewise; of a probe that is not always there, what it
                                       * is where it is */
    size_t machine;                   /* of a mode */
    const struct frob_column *column; /* what is known of it; NULL: nothing */
    const char *below;                /* the end of its name that the column's has not */
};

struct signals {
    const struct frob_program *program;
    struct signal *all;
    size_t count, capacity;
    bool no_memory;
};

/* What there is of an instant. Without a state nothing is known of what is inside. */
struct moment {
    const void *input, *output, *state;
};

/* All signals of a program; `columns` may be NULL. False without memory. */
bool signals_start(struct signals *signals, const struct frob_program *program,
                   const struct frob_column *columns);
void signals_end(struct signals *signals);

/* How much of the output struct the program's output takes: its inner signals come after
 * it. */
size_t signals_output_size(const struct signals *signals);

/* The signal of this name; NULL if there is none. */
const struct signal *signals_find(const struct signals *signals, const char *name);

/* Does it say which mode of a machine runs? */
bool signal_is_mode(const struct signal *signal);

/* Its value as the cell of a trace. */
void signal_write(const struct signals *signals, const struct signal *signal,
                  const struct moment *moment, struct buffer *text);

/* Its value as a number for a plot: truth as 0 and 1, a constructor as its place
 * in the type, an event that occurs as its value, or 1 where that is none. NAN where
 * nothing is: an event that does not occur, the mode of what is not there. */
double signal_number(const struct signals *signals, const struct signal *signal,
                     const struct moment *moment);

/* Are two values the same, bit for bit, as far as a trace shows them? */
bool signal_values_equal(const struct frob_value *value, const void *a, const void *b);

#endif
