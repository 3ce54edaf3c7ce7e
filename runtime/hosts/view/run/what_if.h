/* what_if.h -- an edited program, run over the same inputs as the recorded one, or in the
 * simulator that the recorded one was run in. */
#ifndef FROB_VIEW_WHAT_IF_H
#define FROB_VIEW_WHAT_IF_H

#include "series.h"

struct what_if {
    bool is_there;          /* an edited program has been compiled, and the rest is of it */
    bool drives;            /* it has driven in the simulator, and has inputs of its own */
    struct buffer settings; /* of its parameters, as in a recording */
    struct signals signals;
    struct recording driven;
    struct replay replay;
    struct series series;
    size_t first;                  /* the first instant at which its outputs are others, … */
    const struct signal *first_in; /* … and where; NULL if they never are */
    bool is_repeatable;            /* the simulator has repeated the recording */
};

/* A command, with NULL at its end. */
typedef const char *const *what_if_command;

struct what_if_commands {
    what_if_command build; /* and a program's file: compiles it, and prints the path of the
                            * shared object; NULL: it cannot be */
    what_if_command drive; /* and options and a file, of `frobc run`: runs it in the simulator;
                            * NULL: it cannot be */
};

/* What is another in the program. */
struct what_if_edit {
    const char *text;       /* of its file, as if it were beside what that is beside */
    struct buffer settings; /* of parameters: NAME=VALUE each, with a NUL. Others are set as
                             * recorded, but where the text has another default for them */
    bool drives;            /* it is to run in the simulator */
};

/* Compiles an edited program, and runs it over the whole recording, or, if it `drives`, in the
 * simulator for as long, with the same world and seed; then it is made sure first that the
 * simulator repeats the recording. False if it cannot be, with the reason appended, as the
 * compiler says it. What was there before is gone in any case. */
bool what_if_start(struct what_if *what_if, const struct signals *recorded,
                   struct recording *recording, const struct what_if_commands *commands,
                   const char *file, const struct what_if_edit *edit, struct buffer *why);
void what_if_end(struct what_if *what_if);

#endif
