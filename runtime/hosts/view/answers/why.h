/* why.h -- where a value came from: its equation, and the values that this mentions, at the
 * instants from which they were taken. */
#ifndef FROB_VIEW_WHY_H
#define FROB_VIEW_WHY_H

#include "../run/replay.h"

#include <frob/origins.h>

/* The row that says the most of a signal; NULL if there is none, as in a NULL table. */
const struct frob_origin *why_origin(const struct frob_origin *origins,
                                     const struct signal *signal);

/* Appends, as members of a JSON object, what is known of a signal's value at instant `k`:
 *
 *   "since": {"k", "time", "longer"}: the first instant from which on it is as it is at `k`;
 *            if that is very long ago, one from which on it surely is, and `longer` is true
 *   "file", "line", "last": its equation; "" if it has none
 *   "sources": [{"signal", "k", "time", "cell"}, …]: what it was computed of, and when
 *   "switches": of the running mode of a machine that was in another before, the transitions
 *               that led here at one instant: [{"from", "to", "label", "k", "time", "file",
 *               "line", "last", "sources"}, …]
 *
 * `origins` may be NULL. */
void why_answer(struct replay *replay, const struct frob_origin *origins,
                const struct signal *signal, size_t k, struct buffer *answer);

#endif
