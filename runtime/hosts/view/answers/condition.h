/* condition.h -- what is looked for in a run: an expression over signals, as in a program.
 *
 *   out.forward > 0.3[m/s] && mode.bug == circleTo
 *
 * It has `||`, `&&`, `not`, comparisons, `+ - * /`, `abs`, numbers with units, True and
 * False, names of signals (their ends suffice where only one signal has that end: one of
 * the input or output, or else one inside), and, beside `==` or `/=`, names of modes and
 * constructors. A comparison with what is not there, such as an event that does not occur,
 * does not hold. */
#ifndef FROB_VIEW_CONDITION_H
#define FROB_VIEW_CONDITION_H

#include "../run/series.h"

#define CONDITION_SIZE 256 /* operations, at most */

struct operation;

struct condition {
    struct operation *operations; /* in postfix order */
    size_t count;
};

/* Reads a condition. If it is none, false, and `why` says in a line what is wrong. At most
 * SERIES_KEPT / 2 signals can be in one. */
bool condition_read(struct condition *condition, struct series *series, const char *text,
                    struct buffer *why);
void condition_free(struct condition *condition);

/* Does it hold at instant `k`? */
bool condition_holds(const struct condition *condition, size_t k);

#endif
