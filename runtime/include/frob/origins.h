/* frob/origins.h -- where the values of a trace's columns come from: one step back along
 * the equations of the program.
 *
 * `frobc view` puts such a table beside the program's; hosts look up the symbol
 * `frob_origins`, and need not find it. */
#ifndef FROB_ORIGINS_H
#define FROB_ORIGINS_H

#ifdef __cplusplus
extern "C" {
#endif

enum {
    FROB_ANY = -1,   /* whatever mode ran before, … */
    FROB_BEFORE = -2 /* … or none, as the machine itself began */
};

enum {
    FROB_FIRST = -1, /* only at the first instant of what the signal is in */
    FROB_ENTRY = -2  /* when the mode began that the signal is a parameter in */
};

struct frob_source {
    const char *column;  /* or what the names of several begin with, as `in.sonar` */
    int back;            /* so many instants ago, 0 for the same one, or one of the above */
    const char *machine; /* only where this column, … */
    int mode;            /* … the running mode of a machine, is this one of its constructors; of
                          * FROB_ENTRY: was it before the mode began that runs now, or one of
                          * the below. Else "" */
};

/* From one mode of a machine to another. */
struct frob_transition {
    int from, target;    /* numbers of modes; `from` may be FROB_ANY or FROB_BEFORE */
    const char *label;   /* what it waits for, as far as that is known; else "" */
    int delayed;         /* the instant at which it happens is still of the mode that is left */
    int at_once;         /* it may happen at the first instant of the mode that it leaves */
    const char *file;    /* where it is written, without folders, … */
    unsigned line, last; /* … from and to which line, from 1 */
    const struct frob_source *sources; /* of its event; as in an origin */
};

struct frob_origin {
    const char *column;
    const char *file; /* where its equation is, or where a parameter is given, … */
    unsigned line, last;
    const struct frob_source *sources;         /* ends in one without a column; or NULL */
    const struct frob_transition *transitions; /* of the running mode of a machine, as it
                                                * is a column: ends in one without a label */
};

/* The symbol that hosts look up: an array that ends in a row without a column. */
#define FROB_ORIGINS_SYMBOL "frob_origins"

#ifdef __cplusplus
}
#endif
#endif
