/* what_if.h -- runs an edited program on the inputs of the recorded program, or in the
 * simulator, with the recorded run's world and seed. */
#ifndef FROB_VIEW_WHAT_IF_H
#define FROB_VIEW_WHAT_IF_H

#include "series.h"

struct what_if {
    bool is_there;          /* an edited program was compiled; the rest describes it */
    bool drives;            /* it ran in the simulator, and has its own inputs */
    bool compares;          /* this is another recording (compare.h), not an edited program */
    int64_t shift_ns;       /* its time at time 0 of the shown recording */
    struct buffer settings; /* parameters in the form of a recording */
    struct signals signals;
    struct recording driven;
    struct replay replay;
    struct series series;
    size_t first;                  /* first instant at which its outputs differ */
    const struct signal *first_in; /* output that differs at that instant; NULL if none differs */
    bool is_repeatable;            /* the simulator has reproduced the recording */
};

/* A command, terminated by NULL. */
typedef const char *const *what_if_command;

struct what_if_commands {
    /* Called with a program's file: compiles it, and prints the path of the shared object. NULL:
     * not available. */
    what_if_command build;
    /* Called with options and a file of `frobc run`: runs it in the simulator. NULL: not
     * available. */
    what_if_command drive;
};

/* The changes to the program. */
struct what_if_edit {
    const char *text; /* new text of its file; it can import files from the same directory */
    /* Parameters: NAME=VALUE, each with a NUL. Others have the recorded values, unless the text has
     * a new default for them. */
    struct buffer settings;
    bool drives; /* run it in the simulator */
};

/* Compiles an edited program and runs it over the whole recording; or, if it `drives`, in the
 * simulator for the same duration, with the same world and seed, after checking that the simulator
 * reproduces the recording. On failure returns false and appends the reason, in the compiler's
 * words. The previous edited program is removed in either case. */
bool what_if_start(struct what_if *what_if, const struct signals *recorded,
                   struct recording *recording, const struct what_if_commands *commands,
                   const char *file, const struct what_if_edit *edit, struct buffer *why);
void what_if_end(struct what_if *what_if);

#endif
