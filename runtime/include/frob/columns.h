/* frob/columns.h -- what a programmer knows of the columns of a trace: their units, and
 * where inner signals are written.
 *
 * `frobc view` puts such a table beside the program's; hosts look up the symbol
 * `frob_columns`, and need not find it. */
#ifndef FROB_COLUMNS_H
#define FROB_COLUMNS_H

#ifdef __cplusplus
extern "C" {
#endif

/* Of a column, and of those below it: `probe.follow.pose` is of `probe.follow.pose.x`,
 * `in.sonar` of `in.sonar[3]`. */
struct frob_column {
    const char *name;
    const char *unit;     /* "m/s"; "" without one */
    int is_event;         /* of a probe: an event, and not what is not there at all instants */
    const char *instance; /* of a probe: of which signal function, as in its name; else "" … */
    const char *own;      /* … its own name there … */
    const char *file;     /* … and where that is written, without folders … */
    unsigned line;        /* … from 1 */
};

/* The symbol that hosts look up: an array that ends in a row without a name. */
#define FROB_COLUMNS_SYMBOL "frob_columns"

#ifdef __cplusplus
}
#endif
#endif
