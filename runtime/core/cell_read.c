/* Parses the text of a value by recursive descent, guided by the value's type. The recursion depth
 * depends on the type rather than the text, because the parser counts parentheses instead of
 * recursing on them. */
#include <frob/cell.h>

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct reader {
    const char *start;
    const char *at;
    const char *expected;            /* what was expected at the first failure */
    const struct frob_value *choice; /* the value whose constructor was expected, or NULL */
    void *base;
    const struct frob_frames *frames;
};

static bool fail(struct reader *r, const char *expected)
{
    r->expected = expected;
    return false;
}

static void skip_blanks(struct reader *r)
{
    while (*r->at == ' ' || *r->at == '\t')
        r->at++;
}

static bool accept(struct reader *r, char c)
{
    skip_blanks(r);
    if (*r->at != c)
        return false;
    r->at++;
    return true;
}

static bool is_name_char(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '\'';
}

/* Reads the whole word, or nothing. */
static bool accept_word(struct reader *r, const char *word)
{
    size_t length = strlen(word);
    skip_blanks(r);
    if (strncmp(r->at, word, length) != 0 || is_name_char(r->at[length]))
        return false;
    r->at += length;
    return true;
}

static char *bytes(const struct reader *r, size_t offset)
{
    return (char *)r->base + offset;
}

static bool read_bool(struct reader *r, bool *result)
{
    if (accept_word(r, "true") || accept_word(r, "True"))
        *result = true;
    else if (accept_word(r, "false") || accept_word(r, "False"))
        *result = false;
    else
        return fail(r, "`true` or `false`");
    return true;
}

static bool read_int(struct reader *r, int32_t *result)
{
    static const char expected[] = "an integer from -2147483648 to 2147483647";
    char *end;
    long long n;
    skip_blanks(r);
    if (!(*r->at == '-' || *r->at == '+' || (*r->at >= '0' && *r->at <= '9')))
        return fail(r, expected);
    errno = 0;
    n = strtoll(r->at, &end, 10);
    if (end == r->at || errno != 0 || n < INT32_MIN || n > INT32_MAX || *end == '.' ||
        is_name_char(*end))
        return fail(r, expected);
    r->at = end;
    *result = (int32_t)n;
    return true;
}

/* Reads the whole word, ignoring case, or nothing. `word` must be in lower case. */
static bool accept_word_in_any_case(struct reader *r, const char *word)
{
    size_t length = 0;
    for (; word[length] != '\0'; length++)
        if (r->at[length] != word[length] && r->at[length] != word[length] - 'a' + 'A')
            return false;
    if (is_name_char(r->at[length]))
        return false;
    r->at += length;
    return true;
}

/* Accepts decimal numbers, nan, inf and infinity; strtod would also accept hexadecimal numbers.
 * Rejects decimal numbers that would be rounded to infinity as a double or, if `single`, as a
 * float. */
static bool read_real(struct reader *r, bool single, double *result)
{
    static const char expected[] = "a number";
    const char *digits;
    char *end;
    bool negative;
    skip_blanks(r);
    negative = *r->at == '-';
    digits = r->at + (negative || *r->at == '+' ? 1 : 0);
    if (digits[0] != '\0' && strchr("nNiI", digits[0]) != NULL && is_name_char(digits[1])) {
        const char *start = r->at;
        r->at = digits;
        if (accept_word_in_any_case(r, "nan"))
            *result = NAN;
        else if (accept_word_in_any_case(r, "inf") || accept_word_in_any_case(r, "infinity"))
            *result = negative ? -INFINITY : INFINITY;
        else {
            r->at = start;
            return fail(r, expected);
        }
        return true;
    }
    if (!(digits[0] >= '0' && digits[0] <= '9') && digits[0] != '.')
        return fail(r, expected);
    if (digits[0] == '0' && (digits[1] == 'x' || digits[1] == 'X'))
        return fail(r, expected);
    *result = strtod(r->at, &end);
    if (end == r->at || is_name_char(*end))
        return fail(r, expected);
    if (isinf(single ? (double)(float)*result : *result))
        return fail(r, single ? "a number up to 3.4e38, or `inf`"
                              : "a number up to 1.79e308, or `inf`");
    r->at = end;
    return true;
}

/* Rounds to a double first, and then to a float. */
static bool read_single(struct reader *r, float *result)
{
    double x = 0.0;
    bool ok = read_real(r, true, &x);
    *result = (float)x;
    return ok;
}

/* Reads a non-negative integer of at most `most`, in decimal or, after 0x, in hexadecimal. */
static bool read_natural(struct reader *r, uint64_t most, uint64_t *result)
{
    char *end;
    skip_blanks(r);
    if (!(*r->at >= '0' && *r->at <= '9'))
        return false;
    errno = 0;
    *result = strtoull(r->at, &end, r->at[1] == 'x' ? 16 : 10);
    if (errno != 0 || *result > most || is_name_char(*end))
        return false;
    r->at = end;
    return true;
}

static bool read_image(struct reader *r, const struct frob_image **result)
{
    struct frob_frame_name name;
    uint64_t number = 0;
    const char *expected = "an image that is in a file";
    if (!accept_word(r, "Image") || !read_natural(r, UINT32_MAX, &number) ||
        !read_natural(r, UINT64_MAX, &name.size) || !read_natural(r, UINT64_MAX, &name.hash))
        return fail(r, "an image, as `Image NUMBER SIZE HASH`");
    name.number = (uint32_t)number;
    *result = r->frames == NULL ? NULL : r->frames->find(r->frames->context, &name, &expected);
    return *result != NULL || fail(r, expected);
}

static bool read_value(struct reader *r, const struct frob_value *value);

static bool read_array(struct reader *r, const struct frob_constructor *array)
{
    if (!accept(r, '['))
        return fail(r, "`[`, the start of an array");
    for (size_t i = 0; i < array->count; i++) {
        if (i > 0 && !accept(r, ','))
            return fail(r, "`,` and the array's next element");
        if (!read_value(r, array->fields[i].value))
            return false;
    }
    return accept(r, ']') || fail(r, "`]`");
}

static bool read_tuple(struct reader *r, const struct frob_constructor *tuple)
{
    if (!accept(r, '('))
        return fail(r, tuple->count == 0 ? "`()`" : "`(`, the start of a tuple");
    for (size_t i = 0; i < tuple->count; i++) {
        if (i > 0 && !accept(r, ','))
            return fail(r, "`,` and the tuple's next component");
        if (!read_value(r, tuple->fields[i].value))
            return false;
    }
    return accept(r, ')') || fail(r, "`)`");
}

/* Fields may come in any order, but each only once. */
static bool read_record(struct reader *r, const struct frob_constructor *record)
{
    unsigned long long seen = 0;
    if (!accept(r, '{'))
        return fail(r, "`{` and the record's fields");
    for (size_t n = 0; n < record->count; n++) {
        size_t i;
        const char *name;
        if (n > 0 && !accept(r, ','))
            return fail(r, "`,` and the record's next field");
        skip_blanks(r);
        name = r->at;
        for (i = 0; i < record->count; i++)
            if (accept_word(r, record->fields[i].name))
                break;
        if (i == record->count || (i < 64 && (seen >> i & 1u) != 0)) {
            r->at = name;
            return fail(r, "a field of the record that has no value yet");
        }
        if (i < 64)
            seen |= 1ull << i;
        if (!accept(r, '='))
            return fail(r, "`=` after the field's name");
        if (!read_value(r, record->fields[i].value))
            return false;
    }
    return accept(r, '}') || fail(r, "`}`");
}

static bool read_arguments(struct reader *r, const struct frob_constructor *constructor)
{
    if (constructor->is_record)
        return read_record(r, constructor);
    for (size_t i = 0; i < constructor->count; i++)
        if (!read_value(r, constructor->fields[i].value))
            return false;
    return true;
}

/* Sets to zero every slot that any constructor of the value uses. */
static void clear(struct reader *r, const struct frob_value *value)
{
    char *at = bytes(r, value->offset);
    switch (value->kind) {
    case FROB_BOOL: *(bool *)(void *)at = false; break;
    case FROB_INT: *(int32_t *)(void *)at = 0; break;
    case FROB_FLOAT:
    case FROB_ROUNDED: *(double *)(void *)at = 0.0; break;
    case FROB_SINGLE: *(float *)(void *)at = 0.0f; break;
    case FROB_IMAGE: *(const struct frob_image **)(void *)at = NULL; break;
    case FROB_SUM:
        *(uint8_t *)at = 0;
        /* fall through */
    case FROB_PRODUCT:
    case FROB_ARRAY:
        for (size_t i = 0; i < value->count; i++)
            for (size_t j = 0; j < value->constructors[i].count; j++)
                clear(r, value->constructors[i].fields[j].value);
        break;
    }
}

static bool read_constructor(struct reader *r, const struct frob_value *value)
{
    for (size_t i = 0; i < value->count; i++) {
        if (accept_word(r, value->constructors[i].name)) {
            if (value->kind == FROB_SUM)
                *(uint8_t *)bytes(r, value->offset) = (uint8_t)i;
            return read_arguments(r, &value->constructors[i]);
        }
    }
    r->choice = value;
    return fail(r, "a constructor of the column's type");
}

static bool read_value(struct reader *r, const struct frob_value *value)
{
    /* A tuple's own parenthesis must not be skipped here, because read_tuple reads it. */
    bool tuple = value->kind == FROB_PRODUCT && value->constructors[0].name == NULL;
    int parentheses = 0;
    bool ok = false;
    if (!tuple)
        while (accept(r, '('))
            parentheses++;
    switch (value->kind) {
    case FROB_BOOL: ok = read_bool(r, (bool *)(void *)bytes(r, value->offset)); break;
    case FROB_INT: ok = read_int(r, (int32_t *)(void *)bytes(r, value->offset)); break;
    case FROB_FLOAT: ok = read_real(r, false, (double *)(void *)bytes(r, value->offset)); break;
    case FROB_ROUNDED: ok = read_real(r, true, (double *)(void *)bytes(r, value->offset)); break;
    case FROB_SINGLE: ok = read_single(r, (float *)(void *)bytes(r, value->offset)); break;
    case FROB_PRODUCT:
        ok = tuple ? read_tuple(r, &value->constructors[0]) : read_constructor(r, value);
        break;
    case FROB_SUM:
        clear(r, value);
        ok = read_constructor(r, value);
        break;
    case FROB_ARRAY: ok = read_array(r, &value->constructors[0]); break;
    case FROB_IMAGE:
        ok = read_image(r, (const struct frob_image **)(void *)bytes(r, value->offset));
        break;
    }
    for (; ok && parentheses > 0; parentheses--)
        ok = accept(r, ')') || fail(r, "`)`");
    return ok;
}

static bool is_number(const struct frob_value *value)
{
    return value->kind == FROB_INT || value->kind == FROB_FLOAT || value->kind == FROB_ROUNDED ||
           value->kind == FROB_SINGLE;
}

bool frob_cell_read(const char *cell, const struct frob_value *value, void *base,
                    const struct frob_frames *frames, struct frob_cell_error *error)
{
    struct reader r = { cell, cell, NULL, NULL, base, frames };
    bool ok;
    skip_blanks(&r);
    if (value->kind == FROB_SUM && value->is_event) {
        clear(&r, value);
        ok = true;
        if (*r.at != '\0') {
            *(uint8_t *)bytes(&r, value->offset) = 1;
            ok = read_value(&r, value->constructors[1].fields[0].value);
        }
    } else {
        ok = read_value(&r, value);
    }
    if (ok) {
        skip_blanks(&r);
        if (*r.at != '\0')
            ok = fail(&r, is_number(value) ? "nothing after the number" : "the end of the cell");
    }
    if (!ok) {
        error->position = (size_t)(r.at - r.start);
        error->expected = r.expected;
        error->choice = r.choice;
    }
    return ok;
}
