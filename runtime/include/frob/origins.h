/* frob/origins.h -- the signals from which the values of a trace's columns are computed: one step
 * back along the equations of the program.
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
    FROB_ENTRY = -2  /* the source was read when the mode whose parameter is the signal began */
};

struct frob_source {
    const char *column; /* a column, or the common start of several names, such as `in.sonar` */
    int back;           /* number of instants earlier, 0 for the same instant, or one of the values
                         * above */
    /* The source applies only in one mode of this machine; "" if it always applies. */
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
    const struct frob_source *sources; /* the sources of its event, in the form of an origin's
                                        * sources */
};

struct frob_origin {
    const char *column;
    /* The place of its equation; for a parameter, the place of its argument. */
    const char *file;
    unsigned line, last;
    const struct frob_source *sources; /* ends with a source whose column is NULL; or NULL */
    /* If the column is a machine's running mode, its transitions. The array ends with one whose
     * label is NULL. */
    const struct frob_transition *transitions;
};

/* Symbol that hosts look up. The array ends with a row whose column is NULL. */
#define FROB_ORIGINS_SYMBOL "frob_origins"

#ifdef __cplusplus
}
#endif
#endif
