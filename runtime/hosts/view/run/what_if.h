/* what_if.h -- runs an edited program on the recorded inputs, or in the simulator with the world
 * and the seed of the recorded run. */
#ifndef FROB_VIEW_WHAT_IF_H
#define FROB_VIEW_WHAT_IF_H

#include "series.h"

struct what_if {
    bool is_there;          /* whether an edited program was compiled; the other members describe
                             * it */
    bool drives;            /* whether it ran in the simulator, and has inputs of its own */
    bool compares;          /* whether this is another recording (compare.h) rather than an edited
                             * program */
    int64_t shift_ns;       /* its time that corresponds to time 0 of the shown recording */
    struct buffer settings; /* parameters, in the form used in recordings */
    struct signals signals;
    struct recording driven;
    struct replay replay;
    struct series series;
    size_t first;                  /* the first instant at which its outputs differ */
    const struct signal *first_in; /* the output that differs at that instant; NULL if none
                                    * differs */
    bool is_repeatable;            /* whether the simulator has reproduced the recording */
};

/* A command, terminated by NULL. */
typedef const char *const *what_if_command;

struct what_if_commands {
    /* Compiles the program in the file that is added to it, and prints the path of the shared
     * object. NULL if it is not available. */
    what_if_command build;
    /* Runs a program in the simulator. The options and the file of `frobc run` are added to it.
     * NULL if it is not available. */
    what_if_command drive;
};

/* The changes to the program. */
struct what_if_edit {
    const char *text; /* new text of its file; it can import files from the same directory */
    /* Parameters, each as NAME=VALUE with a NUL. Other parameters have the recorded values, unless
     * the text contains a new default for them. */
    struct buffer settings;
    bool drives; /* whether to run it in the simulator */
};

/* Compiles an edited program and runs it over the whole recording. If `drives` is set, runs it in
 * the simulator instead, for the same duration and with the same world and seed, after checking
 * that the simulator reproduces the recording. On failure, returns false and appends the reason, in
 * the compiler's words. Removes the previous edited program in any case. */
bool what_if_start(struct what_if *what_if, const struct signals *recorded,
                   struct recording *recording, const struct what_if_commands *commands,
                   const char *file, const struct what_if_edit *edit, struct buffer *why);
void what_if_end(struct what_if *what_if);

#endif
