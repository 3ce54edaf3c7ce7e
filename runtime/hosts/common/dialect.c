#include "dialect.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WORD = 300 }; /* room for a quoted argument in a hint */

bool dialect_option(struct csv_dialect *dialect, int argc, char **argv, int *i)
{
    if (strcmp(argv[*i], "--decimal-comma") == 0) {
        dialect->decimal_comma = true;
        return true;
    }
    if (*i + 1 >= argc)
        return false;
    if (strcmp(argv[*i], "--separator") == 0)
        dialect->separator = argv[++*i][0];
    else if (strcmp(argv[*i], "--time-column") == 0)
        dialect->time_column = argv[++*i];
    else if (strcmp(argv[*i], "--column") == 0 && dialect->columns != NULL)
        dialect->columns[dialect->column_count++] = argv[++*i];
    else
        return false;
    return true;
}

bool dialect_names(const struct csv_dialect *dialect)
{
    return dialect->time_column != NULL || dialect->column_count > 0;
}

/* ---- Translating */

static size_t find(const struct csv *csv, const char *name)
{
    size_t i = 0;
    while (i < csv->count && strcmp(csv_cell(csv, i), name) != 0)
        i++;
    return i;
}

static enum csv_status no_column(struct csv *csv, const char *option, const char *name)
{
    size_t length =
        (size_t)snprintf(csv->reason, sizeof csv->reason,
                         "there is no column `%s` for `%s`; the columns are ", name, option);
    const char *separator = dialect_separator_hint(csv);
    for (size_t i = 0; i < csv->count && length < sizeof csv->reason; i++)
        length += (size_t)snprintf(csv->reason + length, sizeof csv->reason - length, "%s`%s`",
                                   i == 0 ? "" : ", ", csv_cell(csv, i));
    if (separator != NULL && length < sizeof csv->reason)
        snprintf(csv->reason + length, sizeof csv->reason - length, "%s", separator);
    return CSV_NO_COLUMN;
}

/* Translates the header to the program's names. */
static enum csv_status rename_columns(struct csv *csv)
{
    const struct csv_dialect *d = &csv->dialect;
    bool *renamed;
    enum csv_status status = CSV_ROW;
    if (d->time_column != NULL) {
        csv->time_cell = find(csv, d->time_column);
        if (csv->time_cell == csv->count)
            return no_column(csv, "--time-column", d->time_column);
    }
    renamed = (bool *)calloc(csv->count, sizeof *renamed);
    if (renamed == NULL)
        return CSV_NO_MEMORY;
    for (size_t k = 0; k < d->column_count && status == CSV_ROW; k++) {
        const char *equals = strchr(d->columns[k], '=');
        const char *column = equals == NULL ? "" : equals + 1;
        const size_t length = (size_t)(column - d->columns[k]);
        char *name = (char *)malloc(length + 1);
        size_t i = 0;
        while (i < csv->count && (renamed[i] || strcmp(csv_cell(csv, i), column) != 0))
            i++;
        if (name == NULL) {
            status = CSV_NO_MEMORY;
        } else if (i == csv->count) {
            status = no_column(csv, "--column", column);
        } else {
            memcpy(name, d->columns[k], length);
            name[length > 0 ? length - 1 : 0] = '\0';
            renamed[i] = true;
            status = csv_replace(csv, i, name) ? CSV_ROW : CSV_NO_MEMORY;
        }
        free(name);
    }
    free(renamed);
    if (status == CSV_ROW && d->time_column != NULL) {
        csv_to_front(csv, csv->time_cell);
        status = csv_replace(csv, 0, "time") ? CSV_ROW : CSV_NO_MEMORY;
    }
    return status;
}

/* Returns the comma in a number such as -0,5e3; NULL if the text is not such a number. */
static char *decimal_comma(const char *text)
{
    const char *at = text + (*text == '-' || *text == '+' ? 1 : 0), *comma;
    while (isdigit((unsigned char)*at))
        at++;
    comma = at;
    if (*at != ',' || !isdigit((unsigned char)at[1]))
        return NULL;
    for (at++; isdigit((unsigned char)*at); at++)
        continue;
    if (*at == 'e' || *at == 'E') {
        at += at[1] == '-' || at[1] == '+' ? 2 : 1;
        if (!isdigit((unsigned char)*at))
            return NULL;
        while (isdigit((unsigned char)*at))
            at++;
    }
    return *at == '\0' ? (char *)comma : NULL;
}

enum csv_status dialect_translate(struct csv *csv)
{
    if (!csv->has_header) {
        for (size_t i = 0; i < csv->count; i++)
            if (strchr(csv_cell(csv, i), '\r') != NULL)
                return CSV_RETURN;
        if (csv_cell(csv, 0)[0] == '#')
            return CSV_ROW;
        csv->has_header = true;
        return dialect_names(&csv->dialect) ? rename_columns(csv) : CSV_ROW;
    }
    if (csv->time_cell > 0 && csv->time_cell < csv->count)
        csv_to_front(csv, csv->time_cell);
    for (size_t i = 0; csv->dialect.decimal_comma && i < csv->count; i++) {
        char *comma = decimal_comma(csv_cell(csv, i));
        if (comma != NULL)
            *comma = '.';
    }
    return CSV_ROW;
}

/* ---- Suggesting options */

static bool is_plain_word(const char *text)
{
    for (; *text != '\0'; text++)
        if (!isalnum((unsigned char)*text) && strchr("_./:-+,%@=", *text) == NULL)
            return false;
    return true;
}

/* Returns the number of bytes of the control character at `text`; 0 if there is none. UTF-8 encodes
 * control characters from 128 on as C2 80 to C2 9F. */
static size_t control_at(const char *text)
{
    const unsigned char c = (unsigned char)text[0], next = c == 0 ? 0 : (unsigned char)text[1];
    if (c == 0xc2 && next >= 0x80 && next < 0xa0)
        return 2;
    return (c != 0 && c < ' ') || c == 0x7f ? 1 : 0;
}

static bool has_control(const char *text)
{
    while (*text != '\0' && control_at(text) == 0)
        text++;
    return *text != '\0';
}

/* Quotes a word that contains control characters. Within $'...', shells replace \ooo by the
 * character with this octal code. */
static const char *word_with_escapes(const char *text, char *word, size_t room)
{
    size_t length = (size_t)snprintf(word, room, "$'"), control = 0;
    for (; *text != '\0' && length + 6 <= room; text++) { /* escape, quote, NUL */
        control = control > 0 ? control : control_at(text);
        length += (size_t)snprintf(word + length, room - length,
                                   control > 0 || *text == '\'' || *text == '\\' ? "\\%03o" : "%c",
                                   (unsigned)(unsigned char)*text);
        control -= control > 0 ? 1 : 0;
    }
    snprintf(word + length, room - length, "'");
    return word;
}

/* Quotes an argument for a shell, and truncates it if it does not fit. Returns `word`. */
static const char *shell_word(const char *text, char *word, size_t room)
{
    const char *const quote = is_plain_word(text) && *text != '\0' ? "" : "'";
    size_t length = (size_t)snprintf(word, room, "%s", quote);
    if (has_control(text))
        return word_with_escapes(text, word, room);
    for (; *text != '\0' && length + 6 <= room; text++) /* escape, quote, NUL */
        length +=
            (size_t)snprintf(word + length, room - length, *text == '\'' ? "'\\%c'" : "%c", *text);
    snprintf(word + length, room - length, "%s", quote);
    return word;
}

static bool has_word(const char *name, const char *word)
{
    for (; *name != '\0'; name++) {
        size_t i = 0;
        while (word[i] != '\0' && tolower((unsigned char)name[i]) == word[i])
            i++;
        if (word[i] == '\0')
            return true;
    }
    return false;
}

static bool is_word(const char *name, const char *word)
{
    return strlen(name) == strlen(word) && has_word(name, word);
}

/* Returns the index of the column that probably contains the times, or the number of columns if
 * there is none. */
static size_t looks_like_time(const struct csv *csv)
{
    size_t i;
    for (i = 0; i < csv->count; i++)
        if (is_word(csv_cell(csv, i), "time"))
            return i;
    for (i = 0; i < csv->count; i++) {
        const char *name = csv_cell(csv, i);
        if (has_word(name, "time") || has_word(name, "stamp") || is_word(name, "t") ||
            is_word(name, "sec") || is_word(name, "secs") || is_word(name, "seconds"))
            break;
    }
    return i;
}

const char *dialect_separator_hint(const struct csv *csv)
{
    const char *first = csv_cell(csv, 0), separator = csv->dialect.separator;
    if (separator != ';' && strchr(first, ';') != NULL)
        return "; its columns are separated by semicolons: add `--separator ';'`";
    if (separator != '\t' && strchr(first, '\t') != NULL)
        return "; its columns are separated by tabs: add `--separator tab`";
    if (separator != ',' && strchr(first, ',') != NULL)
        return "; its columns are separated by commas: remove `--separator`";
    return NULL;
}

const char *dialect_time_hint(struct csv *csv)
{
    const char *separator = dialect_separator_hint(csv);
    const size_t i = looks_like_time(csv);
    char word[WORD];
    if (separator != NULL)
        return separator;
    if (i == csv->count)
        return "; to choose the column with the times, add `--time-column NAME`";
    snprintf(csv->reason, sizeof csv->reason,
             "; to choose the column with the times, add `--time-column %s`",
             shell_word(csv_cell(csv, i), word, sizeof word));
    return csv->reason;
}

const char *dialect_column_hint(struct csv *csv, const char *missing, size_t unknown,
                                const char *other)
{
    const char *column = unknown == 1 ? other : "NAME";
    char setting[WORD], word[WORD];
    if (unknown == 0)
        return "";
    snprintf(setting, sizeof setting, "%s=%s", missing, column);
    snprintf(csv->reason, sizeof csv->reason, "; to read it from another column, add `--column %s`",
             shell_word(setting, word, sizeof word));
    return csv->reason;
}

const char *dialect_number_hint(const struct csv *csv, const char *cell)
{
    return !csv->dialect.decimal_comma && decimal_comma(cell) != NULL
               ? "; for numbers with a decimal comma, add `--decimal-comma`"
               : "";
}

const char *dialect_width_hint(const struct csv *csv, size_t width)
{
    if (csv->count <= width)
        return "";
    if (csv->dialect.decimal_comma && csv->dialect.separator == ',')
        return "; if numbers have a decimal comma, put them in double quotes, or separate the "
               "cells by `;` and add `--separator ';'`";
    return "; put a cell that contains a comma in double quotes";
}
