/* frob/origins.h -- for each column of a trace, the signals from which its value is computed, one
 * step back through the program's equations.
 *
 * `frobc view` builds such a table into the program's shared object. Hosts look up the symbol
 * `frob_origins`; it may be missing. */
#ifndef FROB_ORIGINS_H
#define FROB_ORIGINS_H

#ifdef __cplusplus
extern "C" {
#endif

enum {
    FROB_ANY = -1,   /* any previous mode */
    FROB_BEFORE = -2 /* no previous mode: the machine itself has just started */
};

enum {
    FROB_FIRST = -1, /* the source matters only in the first instant of the signal function that
                      * contains the signal */
    FROB_ENTRY = -2  /* the signal is a parameter of a mode, and the source was read when the mode
                      * began */
};

struct frob_source {
    const char *column; /* a column's name, or a common prefix of several names, such as
                         * `in.sonar` */
    int back;           /* how many instants earlier the source is read (0: in the same
                         * instant), or FROB_FIRST or FROB_ENTRY */
    /* The machine, if the source applies only in one of its modes; otherwise "". */
    const char *machine;
    /* The number of that mode, which must run at the source's instant. For FROB_ENTRY, it is
     * instead the number of the mode that ran before the current one began, or FROB_ANY or
     * FROB_BEFORE. */
    int mode;
};

/* A transition of a machine from one mode to another. */
struct frob_transition {
    int from, target;                  /* mode numbers; `from` may be FROB_ANY or FROB_BEFORE */
    const char *label;                 /* the event that triggers it; "" if it is not known */
    int delayed;                       /* whether the old mode still runs at the instant of the
                                        * event */
    int at_once;                       /* whether it can happen at the first instant of the old
                                        * mode */
    const char *file;                  /* source file, without folders */
    unsigned line, last;               /* first and last line of its source, from 1 */
    const struct frob_source *sources; /* the sources of its event, in the same form as in
                                        * frob_origin */
};

struct frob_origin {
    const char *column;
    /* Source position of the column's equation or, for a parameter, of the argument. */
    const char *file;
    unsigned line, last;
    const struct frob_source *sources; /* NULL, or an array that ends with a NULL column */
    /* The machine's transitions if the column is a machine's running mode. The array ends with a
     * transition whose label is NULL. */
    const struct frob_transition *transitions;
};

/* Symbol that hosts look up. The array ends with a row whose column is NULL. */
#define FROB_ORIGINS_SYMBOL "frob_origins"

#ifdef __cplusplus
}
#endif
#endif
