/* frob/columns.h -- describes the columns of a trace: their units, and where inner signals are
 * defined in the source.
 *
 * `frobc view` builds such a table into the program's shared object. Hosts look up the symbol
 * `frob_columns`; it may be missing. */
#ifndef FROB_COLUMNS_H
#define FROB_COLUMNS_H

#ifdef __cplusplus
extern "C" {
#endif

/* Describes a column and all columns below it: the row `probe.follow.pose` also applies to
 * `probe.follow.pose.x`, and `in.sonar` to `in.sonar[3]`. */
struct frob_column {
    const char *name;
    const char *unit; /* the unit, such as "m/s"; "" if the column is dimensionless or its unit
                       * is unknown */
    /* For a probe: whether it is an event. Other probes may also be absent at some instants. */
    int is_event;
    /* For a probe: the signal function that contains it, as written in the probe's name; otherwise
     * "". */
    const char *instance;
    const char *own;  /* for a probe: its name within its signal function */
    const char *file; /* for a probe: its source file, without folders */
    unsigned line;    /* for a probe: its line in the file, from 1 */
};

/* Symbol that hosts look up. The array ends with a row whose name is NULL. */
#define FROB_COLUMNS_SYMBOL "frob_columns"

#ifdef __cplusplus
}
#endif
#endif
