/* Converts values to text. The recursion is as deep as the value's type, which is fixed when the
 * program is compiled. */
#include <frob/cell.h>

#include <string.h>

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* The position of a value, which determines whether it needs parentheses. */
enum place { ALONE, ARGUMENT };

static const char *bytes(const void *base, size_t offset)
{
    return (const char *)base + offset;
}

static bool reads_back(const char *digits, float x)
{
    double read = strtod(digits, NULL);
    return (float)read == x && (float)nextafter(read, INFINITY) == x &&
           (float)nextafter(read, -INFINITY) == x;
}

/* Writes the fewest digits from which the same float is read back, whether or not the reader
 * rounds to a double first. */
static void write_single(char *digits, size_t size, double x)
{
    for (int precision = 1; precision <= 9; precision++) {
        snprintf(digits, size, "%.*g", precision, x);
        if (reads_back(digits, (float)x))
            break;
    }
}

static bool add_float(struct frob_text *text, double x, bool is_single)
{
    char digits[32];
    if (isnan(x)) {
        frob_text_add(text, "nan");
        return false;
    }
    if (isinf(x)) {
        frob_text_add(text, x < 0 ? "-inf" : "inf");
        return x < 0;
    }
    if (is_single)
        write_single(digits, sizeof digits, x);
    else
        snprintf(digits, sizeof digits, "%.17g", x);
    frob_text_add(text, digits);
    return digits[0] == '-';
}

static void add_value(struct frob_text *text, const struct frob_value *value, const void *base,
                      enum place place);

static void add_parts(struct frob_text *text, const struct frob_constructor *parts,
                      const void *base)
{
    for (size_t i = 0; i < parts->count; i++) {
        if (i > 0)
            frob_text_add(text, ", ");
        add_value(text, parts->fields[i].value, base, ALONE);
    }
}

static void add_tuple(struct frob_text *text, const struct frob_constructor *tuple,
                      const void *base)
{
    frob_text_add_char(text, '(');
    add_parts(text, tuple, base);
    frob_text_add_char(text, ')');
}

static void add_record(struct frob_text *text, const struct frob_constructor *record,
                       const void *base)
{
    frob_text_add(text, record->name);
    frob_text_add(text, " {");
    for (size_t i = 0; i < record->count; i++) {
        if (i > 0)
            frob_text_add(text, ", ");
        frob_text_add(text, record->fields[i].name);
        frob_text_add(text, " = ");
        add_value(text, record->fields[i].value, base, ALONE);
    }
    frob_text_add_char(text, '}');
}

static void add_constructor(struct frob_text *text, const struct frob_constructor *constructor,
                            const void *base, enum place place)
{
    if (constructor->name == NULL) {
        add_tuple(text, constructor, base);
    } else if (constructor->is_record) {
        add_record(text, constructor, base);
    } else {
        bool parentheses = place == ARGUMENT && constructor->count > 0;
        if (parentheses)
            frob_text_add_char(text, '(');
        frob_text_add(text, constructor->name);
        for (size_t i = 0; i < constructor->count; i++) {
            frob_text_add_char(text, ' ');
            add_value(text, constructor->fields[i].value, base, ARGUMENT);
        }
        if (parentheses)
            frob_text_add_char(text, ')');
    }
}

/* As an argument, a negative number needs parentheses. */
static void add_number(struct frob_text *text, double x, bool is_single, enum place place)
{
    char digits[48];
    struct frob_text number = frob_text_in(digits, sizeof digits);
    if (add_float(&number, x, is_single) && place == ARGUMENT) {
        frob_text_add_char(text, '(');
        frob_text_add(text, digits);
        frob_text_add_char(text, ')');
    } else {
        frob_text_add(text, digits);
    }
}

static void add_image(struct frob_text *text, const struct frob_image *image, enum place place)
{
    char name[80];
    struct frob_frame_name frame;
    if (image == NULL) {
        frob_text_add(text, "?"); /* only foreign code can return NULL */
        return;
    }
    frame = frob_frame_name_of(image);
    /* Not PRIu64, because the newlib of Debian's arm-none-eabi-gcc defines no 64-bit formats. */
    snprintf(name, sizeof name,
             place == ARGUMENT ? "(Image %" PRIu32 " %llu 0x%016llx)"
                               : "Image %" PRIu32 " %llu 0x%016llx",
             frame.number, (unsigned long long)frame.size, (unsigned long long)frame.hash);
    frob_text_add(text, name);
}

static void add_value(struct frob_text *text, const struct frob_value *value, const void *base,
                      enum place place)
{
    const char *at = bytes(base, value->offset);
    switch (value->kind) {
    case FROB_BOOL: frob_text_add(text, *(const bool *)(const void *)at ? "true" : "false"); break;
    case FROB_INT: {
        int32_t n = *(const int32_t *)(const void *)at;
        char digits[16];
        bool parentheses = n < 0 && place == ARGUMENT;
        snprintf(digits, sizeof digits, parentheses ? "(%" PRId32 ")" : "%" PRId32, n);
        frob_text_add(text, digits);
        break;
    }
    case FROB_FLOAT: add_number(text, *(const double *)(const void *)at, false, place); break;
    case FROB_SINGLE:
        add_number(text, (double)*(const float *)(const void *)at, true, place);
        break;
    case FROB_ROUNDED:
        add_number(text, (double)(float)*(const double *)(const void *)at, true, place);
        break;
    case FROB_PRODUCT: add_constructor(text, &value->constructors[0], base, place); break;
    case FROB_SUM: {
        uint8_t tag = *(const uint8_t *)at;
        if (tag < value->count)
            add_constructor(text, &value->constructors[tag], base, place);
        else
            frob_text_add(text, "?"); /* only foreign code can return such a tag */
        break;
    }
    case FROB_ARRAY:
        frob_text_add_char(text, '[');
        add_parts(text, &value->constructors[0], base);
        frob_text_add_char(text, ']');
        break;
    case FROB_IMAGE:
        add_image(text, *(const struct frob_image *const *)(const void *)at, place);
        break;
    }
}

void frob_cell_write(struct frob_text *text, const struct frob_value *value, const void *base)
{
    if (value->kind == FROB_SUM && value->is_event) {
        if (*(const uint8_t *)bytes(base, value->offset) == 1)
            add_value(text, value->constructors[1].fields[0].value, base, ALONE);
    } else {
        add_value(text, value, base, ALONE);
    }
}

/* Adds up the space that all constructors need, although only one of them is written. */
size_t frob_cell_room(const struct frob_value *value)
{
    size_t room = value->kind == FROB_IMAGE ? 80 : 32; /* space for a number, parentheses and
                                                        * separators */
    if (value->kind == FROB_PRODUCT || value->kind == FROB_SUM || value->kind == FROB_ARRAY) {
        for (size_t i = 0; i < value->count; i++) {
            const struct frob_constructor *c = &value->constructors[i];
            room += c->name == NULL ? 0 : strlen(c->name) + 8;
            for (size_t j = 0; j < c->count; j++) {
                const struct frob_field *field = &c->fields[j];
                room += frob_cell_room(field->value);
                room += field->name == NULL ? 0 : strlen(field->name) + 8;
            }
        }
    }
    return room;
}
