/* dialect.h -- reads recordings from other programs, with a different separator, a decimal comma,
 * or other column names. If such a file is rejected, the error message suggests the options. */
#ifndef FROB_HOST_DIALECT_H
#define FROB_HOST_DIALECT_H

#include "csv.h"

/* If argv[*i] is an option of the dialect, reads the option with its value, sets *i to the index of
 * its last argument, and returns true. `dialect->columns` must have room for `argc` entries. */
bool dialect_option(struct csv_dialect *dialect, int argc, char **argv, int *i);

/* Returns whether the dialect names columns. If so, columns of the recording that are unknown to
 * the program are ignored. */
bool dialect_names(const struct csv_dialect *dialect);

/* Translates the row that was read last. Returns CSV_ROW, CSV_RETURN, CSV_NO_COLUMN or
 * CSV_NO_MEMORY. */
enum csv_status dialect_translate(struct csv *csv);

/* Hints for error messages. Each string is valid until the next call with this csv, and empty if
 * no option would help. */

/* Hint for the error that the first column of the header must be `time`. */
const char *dialect_time_hint(struct csv *csv);

/* The part of dialect_time_hint about a different separator; NULL if the separator seems right. If
 * it is not NULL, the header was split in the wrong places, so the caller must not report other
 * columns. */
const char *dialect_separator_hint(const struct csv *csv);

/* Hint for the error that a column is missing. `unknown`: the number of columns in the recording
 * that the program does not know; `other`: one of them. */
const char *dialect_column_hint(struct csv *csv, const char *missing, size_t unknown,
                                const char *other);

/* Hint for the error that the current row does not have `width` cells, as the header does. */
const char *dialect_width_hint(const struct csv *csv, size_t width);

/* Hint for the error that a cell is not a number. */
const char *dialect_number_hint(const struct csv *csv, const char *cell);

#endif
