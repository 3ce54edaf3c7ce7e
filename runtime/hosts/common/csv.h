/* csv.h -- rows of a CSV file, as in RFC 4180 (LF or CRLF; a byte-order mark
 * at the start is skipped). */
#ifndef FROB_HOST_CSV_H
#define FROB_HOST_CSV_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

struct csv {
    FILE *file;
    unsigned long line; /* on which the current row starts, from 1 */
    /* the current row */
    size_t count;
    size_t *columns; /* byte column of each cell's first character, from 1 */
    /* private */
    unsigned long next_line;
    char *text;
    size_t *starts; /* of the cells in the text, which moves as it grows */
    size_t text_capacity, cells_capacity;
    char *read;                            /* a line of the file, … */
    size_t read_capacity, read_length, at; /* … as far as it is a row's already */
};

enum csv_status {
    CSV_ROW,
    CSV_END,
    CSV_UNREADABLE,
    CSV_UNCLOSED_QUOTE,
    CSV_LATE_QUOTE, /* the last cell has blanks before its quote */
    CSV_NUL,
    CSV_NO_MEMORY
};

void csv_start(struct csv *csv, FILE *file);

/* The next row that is not an empty line. */
enum csv_status csv_next(struct csv *csv);

/* A cell of the current row, unquoted; good until the next row. */
const char *csv_cell(const struct csv *csv, size_t index);

void csv_end(struct csv *csv);

#endif
