/* why.h -- explains where a value came from: shows its equation, and the values that the equation
 * read, with their instants. */
#ifndef FROB_VIEW_WHY_H
#define FROB_VIEW_WHY_H

#include "../run/replay.h"

#include <frob/origins.h>

/* Returns the most specific row about a signal; NULL if there is none or the table is NULL. */
const struct frob_origin *why_origin(const struct frob_origin *origins,
                                     const struct signal *signal);

/* Appends the known facts about a signal's value at instant `k`, as members of a JSON object:
 *
 *   "since": {"k", "time", "longer"}: the instant from which it has had this value;
 *            if that is too long ago, a later instant, and `longer` is true
 *   "file", "line", "last": the location of its equation; "" if it has none
 *   "sources": [{"signal", "k", "time", "cell"}, …]: the values it was computed from, and the
 *              instants at which they were read
 *   "switches": if the signal is the running mode of a machine that had a different mode before,
 *               the transitions of one instant that led here: [{"from", "to", "label", "k",
 *               "time", "file", "line", "last", "sources"}, …]
 *
 * `origins` may be NULL. */
void why_answer(struct replay *replay, const struct frob_origin *origins,
                const struct signal *signal, size_t k, struct buffer *answer);

/* An operand of a computed value, and the instant at which it was read. */
struct why_source {
    const struct signal *signal;
    size_t k;
};

/* Finds at most `most` sources of a signal's value at instant `k`. Returns their number. */
size_t why_sources(struct replay *replay, const struct frob_origin *origins,
                   const struct signal *signal, size_t k, struct why_source *found, size_t most);

#endif
