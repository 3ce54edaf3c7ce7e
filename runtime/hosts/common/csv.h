/* csv.h -- reads the rows of a CSV file, as in RFC 4180 (LF or CRLF; a byte-order mark at the start
 * is skipped). */
#ifndef FROB_HOST_CSV_H
#define FROB_HOST_CSV_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* How the format of a recording from another program differs from Frob's. */
struct csv_dialect {
    char separator;          /* separator between cells; 0 for a comma */
    bool decimal_comma;      /* whether numbers have a decimal comma, as in 0,5 */
    const char *time_column; /* name of the time column; NULL for the first column, `time` */
    const char **columns;    /* NAME=COLUMN, for a column with a different name */
    size_t column_count;
};

/* Error message for CSV_RETURN. */
#define CSV_RETURN_REASON \
    "the lines end with carriage returns only: convert them to line feeds with `tr '\\r' '\\n'`"

/* Maximum length of a row. It bounds the memory used, whatever a file contains. */
#define CSV_LONGEST (16u << 20)
#define CSV_MOST_CELLS 1000000u

struct csv {
    FILE *file;
    struct csv_dialect dialect;
    unsigned long line; /* line on which the current row starts, from 1 */
    /* the current row */
    size_t count;
    size_t *columns;  /* column of each cell's first character, in bytes from 1 */
    char reason[600]; /* the message for CSV_NO_COLUMN */
    /* private */
    bool has_header;
    size_t time_cell; /* index of the time cell in the file's rows */
    unsigned long next_line;
    char *text;
    size_t *starts; /* offsets of the cells in `text`; not pointers, because realloc may move it */
    size_t text_capacity, cells_capacity;
    char *read;                            /* the current line of the file */
    size_t read_capacity, read_length, at; /* `at`: number of bytes of `read` consumed */
};

enum csv_status {
    CSV_ROW,
    CSV_END,
    CSV_UNREADABLE,
    CSV_UNCLOSED_QUOTE,
    CSV_LATE_QUOTE, /* the last cell has spaces before its quote */
    CSV_NUL,
    CSV_RETURN,    /* the header has a carriage return without a line feed after it */
    CSV_NO_COLUMN, /* the dialect names a column that is missing; see `reason` */
    CSV_TOO_LONG,  /* a row has more than CSV_LONGEST bytes or CSV_MOST_CELLS cells */
    CSV_NO_MEMORY
};

/* `dialect`: NULL for recordings in our own format. */
void csv_start(struct csv *csv, FILE *file, const struct csv_dialect *dialect);

/* Reads the next non-empty row, and translates it from the dialect: the time becomes the first
 * column, called `time`, and the other columns get the program's names. Lines before the header
 * that begin with `#` are returned unchanged. */
enum csv_status csv_next(struct csv *csv);

/* Replaces the text of a cell of the current row. Returns false if memory runs out. */
bool csv_replace(struct csv *csv, size_t index, const char *text);

/* Moves a cell of the current row to the front. */
void csv_to_front(struct csv *csv, size_t index);

/* Returns a cell of the current row, unquoted; valid until the next row. */
const char *csv_cell(const struct csv *csv, size_t index);

void csv_end(struct csv *csv);

#endif
