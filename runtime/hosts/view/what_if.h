/* what_if.h -- an edited program, run over the same inputs as the recorded one. */
#ifndef FROB_VIEW_WHAT_IF_H
#define FROB_VIEW_WHAT_IF_H

#include "series.h"

struct what_if {
    bool is_there; /* an edited program has been compiled, and the rest is of it */
    struct signals signals;
    struct replay replay;
    struct series series;
};

/* How the program is compiled: a command whose last argument is the program's file, and
 * which prints the path of the shared object. NULL at the end. */
typedef const char *const *what_if_command;

/* Compiles an edited text of the program's file, as if it were beside what that is beside,
 * and runs it over the whole recording. False if it cannot be, with the reason appended, as the
 * compiler says it. What was there before is gone in any case. */
bool what_if_start(struct what_if *what_if, const struct signals *recorded,
                   const struct recording *recording, what_if_command command,
                   const char *file, const char *text, struct buffer *why);
void what_if_end(struct what_if *what_if);

#endif
