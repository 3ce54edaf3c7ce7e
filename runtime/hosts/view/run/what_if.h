/* what_if.h -- runs an edited program on the recorded inputs, or in the simulator with the world
 * and the seed of the recorded run. */
#ifndef FROB_VIEW_WHAT_IF_H
#define FROB_VIEW_WHAT_IF_H

#include "series.h"

struct what_if {
    bool is_there;          /* whether there is an edited program, which the other members
                             * describe */
    bool drives;            /* whether it has its own inputs, from the simulator or another
                             * recording */
    bool compares;          /* whether this is another recording (compare.h) rather than an edited
                             * program */
    int64_t shift_ns;       /* time in this run that corresponds to time 0 of the displayed
                             * recording */
    struct buffer settings; /* parameters, in the form used in recordings */
    struct signals signals;
    struct recording driven;
    struct replay replay;
    struct series series;
    size_t first;                  /* first instant at which the outputs differ from the
                                    * recording */
    const struct signal *first_in; /* the output that differs at that instant; NULL if none
                                    * differs */
    bool is_repeatable;            /* whether the simulator has reproduced the recording */
};

/* A command, terminated by NULL. */
typedef const char *const *what_if_command;

struct what_if_commands {
    /* The command that compiles a program and prints the path of the shared object; NULL if it is
     * not available. The program's file is appended to the command. */
    what_if_command build;
    /* The command that runs a program in the simulator; NULL if it is not available. The options
     * and the file for `frobc run` are appended to the command. */
    what_if_command drive;
};

/* A change to a program and its parameters. */
struct what_if_edit {
    const char *text; /* new source text; it can import files from the directory of the original */
    /* Parameters: NUL-terminated strings NAME=VALUE. Other parameters keep their recorded values,
     * unless the text contains a new default for them. */
    struct buffer settings;
    bool drives; /* whether to run the edited program in the simulator */
};

/* Compiles an edited program and runs it over the whole recording. If `drives` is set, runs it in
 * the simulator instead, for the same duration and with the same world and seed, after checking
 * that the simulator reproduces the recording. On failure, returns false and appends the reason,
 * such as the compiler's messages. Always removes the previous edited program. */
bool what_if_start(struct what_if *what_if, const struct signals *recorded,
                   struct recording *recording, const struct what_if_commands *commands,
                   const char *file, const struct what_if_edit *edit, struct buffer *why);
void what_if_end(struct what_if *what_if);

#endif
