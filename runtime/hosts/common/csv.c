#include "csv.h"

#include <stdlib.h>
#include <string.h>
#include <sys/types.h>

void csv_start(struct csv *csv, FILE *file)
{
    memset(csv, 0, sizeof *csv);
    csv->file = file;
    csv->next_line = 1;
}

void csv_end(struct csv *csv)
{
    free(csv->text);
    free(csv->starts);
    free(csv->columns);
    free(csv->read);
}

/* Room for one more character of the row's text. */
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

/* Takes the next line of the file, whole; false at its end. */
static bool read_line(struct csv *csv)
{
    ssize_t length = getline(&csv->read, &csv->read_capacity, csv->file);
    csv->at = 0;
    csv->read_length = length < 0 ? 0 : (size_t)length;
    return csv->read_length > 0;
}

static int get(struct csv *csv)
{
    if (csv->at == csv->read_length && !read_line(csv))
        return EOF;
    return (unsigned char)csv->read[csv->at++];
}

/* After a character that was no end of a line, so it is in the same one. */
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

/* Is the line that was read a row as most are, of cells as they stand there? */
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
        char *comma = (char *)memchr(csv->text + start, ',', length - start);
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

enum csv_status csv_next(struct csv *csv)
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
        if (!grow_text(csv, length + 1) || !grow_cells(csv))
            return CSV_NO_MEMORY;
        if (cell_starts && c != EOF) {
            cell_starts = false;
            blank = c == ' ' || c == '\t';
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
            if (cell_starts) { /* an empty last cell */
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
        } else if (!quoted && c == ',') {
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
