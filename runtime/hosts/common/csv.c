#include "csv.h"

#include <stdlib.h>
#include <string.h>

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
}

/* Room for one more character of the row's text. */
static bool grow_text(struct csv *csv, size_t length)
{
    size_t capacity = csv->text_capacity == 0 ? 4096 : csv->text_capacity * 2;
    char *text;
    if (length < csv->text_capacity)
        return true;
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

static int next_char(struct csv *csv)
{
    int c = getc_unlocked(csv->file);
    if (c == '\r') {
        int after = getc_unlocked(csv->file);
        if (after == '\n')
            return '\n';
        if (after != EOF)
            ungetc(after, csv->file);
    }
    return c;
}

static void skip_byte_order_mark(struct csv *csv)
{
    static const int mark[] = { 0xef, 0xbb, 0xbf };
    int c = getc_unlocked(csv->file);
    if (c != mark[0]) {
        if (c != EOF)
            ungetc(c, csv->file);
        return;
    }
    (void)getc_unlocked(csv->file);
    (void)getc_unlocked(csv->file);
}

const char *csv_cell(const struct csv *csv, size_t index)
{
    return csv->text + csv->starts[index];
}

enum csv_status csv_next(struct csv *csv)
{
    size_t length = 0, column = 1;
    bool quoted = false, cell_starts = true, blank = false;
    csv->count = 0;
    if (csv->next_line == 1)
        skip_byte_order_mark(csv);
    csv->line = csv->next_line;
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
            int after = getc_unlocked(csv->file);
            if (after == '"') {
                csv->text[length++] = '"';
                column++;
                continue;
            }
            if (after != EOF)
                ungetc(after, csv->file);
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
