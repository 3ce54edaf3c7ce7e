/* condition.h -- conditions to find in a run: expressions over signals, in the syntax of programs.
 *
 *   out.forward > 0.3[m/s] && mode.bug == circleTo
 *
 * A condition may contain `||`, `&&`, `not`, comparisons, `+ - * /`, `abs`, numbers with units,
 * True and False, `time` (since the start of the run), names of signals and, as operands of `==`
 * and `/=`, names of modes and constructors. The end of a signal's name suffices if it identifies
 * one signal of the input or output, or else one inner signal. Units must be consistent, as in the
 * language; 0 has any unit. A comparison with a value that does not exist, such as an event that
 * does not occur, is false. */
#ifndef FROB_VIEW_CONDITION_H
#define FROB_VIEW_CONDITION_H

#include "../run/series.h"

#define CONDITION_SIZE 256 /* maximum number of operations */

struct operation;

struct condition {
    struct operation *operations; /* in postfix order */
    size_t count;
};

/* Parses a condition. If it is invalid, returns false and describes the error in `why`, on one
 * line. A condition may contain at most SERIES_KEPT / 2 signals. */
bool condition_read(struct condition *condition, struct series *series, const char *text,
                    struct buffer *why);
void condition_free(struct condition *condition);

/* Returns whether the condition holds at instant `k`, whose time is `seconds`. */
bool condition_holds(const struct condition *condition, size_t k, double seconds);

#endif
