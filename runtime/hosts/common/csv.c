#ifndef _GNU_SOURCE
#define _GNU_SOURCE /* getc_unlocked */
#endif

#include "csv.h"

#include "dialect.h"

#include <stdlib.h>
#include <string.h>

void csv_start(struct csv *csv, FILE *file, const struct csv_dialect *dialect)
{
    memset(csv, 0, sizeof *csv);
    csv->file = file;
    if (dialect != NULL)
        csv->dialect = *dialect;
    if (csv->dialect.separator == '\0')
        csv->dialect.separator = ',';
    csv->next_line = 1;
}

void csv_end(struct csv *csv)
{
    free(csv->text);
    free(csv->starts);
    free(csv->columns);
    free(csv->read);
}

/* Makes room for more than `length` characters of the row's text. */
static bool grow_text(struct csv *csv, size_t length)
{
    size_t capacity = csv->text_capacity == 0 ? 4096 : csv->text_capacity;
    char *text;
    if (length < csv->text_capacity)
        return true;
    while (capacity <= length)
        capacity *= 2;
    text = (char *)realloc(csv->text, capacity);
    if (text == NULL)
        return false;
    csv->text = text;
    csv->text_capacity = capacity;
    return true;
}

static bool grow_cells(struct csv *csv)
{
    size_t capacity = csv->cells_capacity == 0 ? 64 : csv->cells_capacity * 2;
    size_t *starts, *columns;
    if (csv->count < csv->cells_capacity)
        return true;
    starts = (size_t *)realloc(csv->starts, capacity * sizeof *starts);
    if (starts == NULL)
        return false;
    csv->starts = starts;
    columns = (size_t *)realloc(csv->columns, capacity * sizeof *columns);
    if (columns == NULL)
        return false;
    csv->columns = columns;
    csv->cells_capacity = capacity;
    return true;
}

/* Reads the next line of the file. Stops after the maximum length, or after a NUL, which is not
 * allowed in recordings. Returns false at the end of the file, or if memory runs out. */
static bool read_line(struct csv *csv)
{
    size_t length = 0;
    int c;
    bool ends = false;
    while (length <= CSV_LONGEST && !ends && (c = getc_unlocked(csv->file)) != EOF) {
        if (length == csv->read_capacity) {
            const size_t capacity = length == 0 ? 4096 : length * 2;
            char *read = (char *)realloc(csv->read, capacity);
            if (read == NULL)
                break;
            csv->read = read;
            csv->read_capacity = capacity;
        }
        csv->read[length++] = (char)c;
        ends = c == '\n' || c == '\0';
    }
    csv->at = 0;
    csv->read_length = length;
    return length > 0;
}

static int get(struct csv *csv)
{
    if (csv->at == csv->read_length && !read_line(csv))
        return EOF;
    return (unsigned char)csv->read[csv->at++];
}

/* Puts back the last character. It was not the end of a line, so it belongs to the current line. */
static void unget(struct csv *csv)
{
    csv->at--;
}

static int next_char(struct csv *csv)
{
    int c = get(csv);
    if (c == '\r') {
        int after = get(csv);
        if (after == '\n')
            return '\n';
        if (after != EOF)
            unget(csv);
    }
    return c;
}

static void skip_byte_order_mark(struct csv *csv)
{
    static const int mark[] = { 0xef, 0xbb, 0xbf };
    int c = get(csv);
    if (c != mark[0]) {
        if (c != EOF)
            unget(csv);
        return;
    }
    (void)get(csv);
    (void)get(csv);
}

const char *csv_cell(const struct csv *csv, size_t index)
{
    return csv->text + csv->starts[index];
}

/* Returns whether the line can simply be split at its separators. This is true for most lines:
 * those without quotes, carriage returns or NULs. */
static bool is_plain(const struct csv *csv)
{
    const char *line = csv->read;
    const size_t length = csv->read_length;
    return length > 1 && line[length - 1] == '\n' && memchr(line, '"', length) == NULL &&
           memchr(line, '\r', length) == NULL && memchr(line, '\0', length) == NULL;
}

static enum csv_status take_plain(struct csv *csv)
{
    const size_t length = csv->read_length - 1;
    if (!grow_text(csv, length))
        return CSV_NO_MEMORY;
    memcpy(csv->text, csv->read, length);
    csv->text[length] = '\0';
    for (size_t start = 0;;) {
        char *comma = (char *)memchr(csv->text + start, csv->dialect.separator, length - start);
        if (csv->count == CSV_MOST_CELLS)
            return CSV_TOO_LONG;
        if (!grow_cells(csv))
            return CSV_NO_MEMORY;
        csv->columns[csv->count] = start + 1;
        csv->starts[csv->count++] = start;
        if (comma == NULL)
            break;
        *comma = '\0';
        start = (size_t)(comma - csv->text) + 1;
    }
    csv->at = csv->read_length;
    csv->next_line++;
    return CSV_ROW;
}

static enum csv_status next_row(struct csv *csv)
{
    size_t length = 0, column = 1;
    bool quoted = false, cell_starts = true, blank = false;
    csv->count = 0;
    if (csv->next_line == 1)
        skip_byte_order_mark(csv);
    csv->line = csv->next_line;
    if (csv->at == csv->read_length && read_line(csv) && is_plain(csv))
        return take_plain(csv);
    for (;;) {
        int c = next_char(csv);
        if (length > CSV_LONGEST || csv->count > CSV_MOST_CELLS)
            return CSV_TOO_LONG;
        if (!grow_text(csv, length + 1) || !grow_cells(csv))
            return CSV_NO_MEMORY;
        if (cell_starts && c != EOF) {
            cell_starts = false;
            blank = (c == ' ' || c == '\t') && c != csv->dialect.separator;
            csv->columns[csv->count] = column + (c == '"' ? 1u : 0u);
            csv->starts[csv->count++] = length;
            if (c == '"') {
                quoted = true;
                column++;
                continue;
            }
        }
        if (c == EOF) {
            if (ferror(csv->file))
                return CSV_UNREADABLE;
            if (quoted)
                return CSV_UNCLOSED_QUOTE;
            if (csv->count == 0)
                return CSV_END;
            if (cell_starts) { /* the last cell is empty */
                csv->columns[csv->count] = column;
                csv->starts[csv->count++] = length;
            }
            break;
        }
        if (c == '\0')
            return CSV_NUL;
        if (blank && c == '"')
            return CSV_LATE_QUOTE;
        blank = blank && (c == ' ' || c == '\t');
        if (c == '\n')
            csv->next_line++;
        column++;
        if (quoted && c == '"') {
            int after = get(csv);
            if (after == '"') {
                csv->text[length++] = '"';
                column++;
                continue;
            }
            if (after != EOF)
                unget(csv);
            quoted = false;
        } else if (!quoted && c == csv->dialect.separator) {
            csv->text[length++] = '\0';
            cell_starts = true;
        } else if (!quoted && c == '\n') {
            if (csv->count == 1 && length == 0) { /* an empty line */
                csv->count = 0;
                csv->line = csv->next_line;
                cell_starts = true;
                column = 1;
                continue;
            }
            break;
        } else {
            csv->text[length++] = (char)c;
        }
    }
    csv->text[length] = '\0';
    return CSV_ROW;
}

enum csv_status csv_next(struct csv *csv)
{
    const enum csv_status status = next_row(csv);
    return status == CSV_ROW ? dialect_translate(csv) : status;
}

bool csv_replace(struct csv *csv, size_t index, const char *text)
{
    const size_t last = csv->count - 1, length = strlen(text);
    size_t end = 0;
    for (size_t i = 0; i <= last; i++) {
        const size_t after = csv->starts[i] + strlen(csv->text + csv->starts[i]) + 1;
        end = after > end ? after : end;
    }
    if (!grow_text(csv, end + length + 1))
        return false;
    memcpy(csv->text + end, text, length + 1);
    csv->starts[index] = end;
    return true;
}

void csv_to_front(struct csv *csv, size_t index)
{
    const size_t start = csv->starts[index], column = csv->columns[index];
    memmove(csv->starts + 1, csv->starts, index * sizeof *csv->starts);
    memmove(csv->columns + 1, csv->columns, index * sizeof *csv->columns);
    csv->starts[0] = start;
    csv->columns[0] = column;
}
