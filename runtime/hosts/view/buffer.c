#include "buffer.h"

#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void buffer_clear(struct buffer *b)
{
    b->length = 0;
    b->failed = b->is_binary = false;
    if (b->data != NULL)
        b->data[0] = '\0';
}

void buffer_free(struct buffer *b)
{
    free(b->data);
    memset(b, 0, sizeof *b);
}

static bool has_room(struct buffer *b, size_t more)
{
    size_t needed = b->length + more + 1, capacity = b->capacity == 0 ? 256 : b->capacity;
    char *data;
    if (needed <= b->capacity)
        return true;
    while (capacity < needed)
        capacity *= 2;
    data = (char *)realloc(b->data, capacity);
    if (data == NULL) {
        b->failed = true;
        return false;
    }
    b->data = data;
    b->capacity = capacity;
    return true;
}

void buffer_bytes(struct buffer *b, const char *bytes, size_t length)
{
    if (!has_room(b, length))
        return;
    memcpy(b->data + b->length, bytes, length);
    b->length += length;
    b->data[b->length] = '\0';
}

void buffer_text(struct buffer *b, const char *text)
{
    buffer_bytes(b, text, strlen(text));
}

void buffer_format(struct buffer *b, const char *format, ...)
{
    va_list arguments;
    int length;
    va_start(arguments, format);
    length = vsnprintf(NULL, 0, format, arguments);
    va_end(arguments);
    if (length < 0 || !has_room(b, (size_t)length))
        return;
    va_start(arguments, format);
    vsnprintf(b->data + b->length, (size_t)length + 1, format, arguments);
    va_end(arguments);
    b->length += (size_t)length;
}

/* Returns the number of bytes in the character at `at`; 0 if it is not valid UTF-8 (RFC 3629: the
 * shortest form, no surrogates, at most U+10FFFF). */
static size_t utf8_length(const unsigned char *at)
{
    static const uint32_t least[] = { 0, 0, 0x80, 0x800, 0x10000 };
    size_t length = *at < 0x80                  ? 1
                    : *at >= 0xc2 && *at < 0xe0 ? 2
                    : (*at & 0xf0) == 0xe0      ? 3
                    : *at >= 0xf0 && *at < 0xf5 ? 4
                                                : 0;
    uint32_t code;
    if (length < 2)
        return length;
    code = *at & (0x7fu >> length);
    for (size_t i = 1; i < length; i++) {
        if ((at[i] & 0xc0) != 0x80)
            return 0;
        code = code << 6 | (at[i] & 0x3fu);
    }
    return code >= least[length] && code <= 0x10ffff && (code < 0xd800 || code > 0xdfff) ? length
                                                                                         : 0;
}

void buffer_string(struct buffer *b, const char *text)
{
    const unsigned char *at = (const unsigned char *)text;
    buffer_text(b, "\"");
    while (*at != '\0') {
        size_t length = utf8_length(at);
        if (length == 0)
            buffer_text(b, "\xef\xbf\xbd");
        else if (*at == '"' || *at == '\\')
            buffer_format(b, "\\%c", *at);
        else if (*at < 0x20)
            buffer_format(b, "\\u%04x", *at);
        else
            buffer_bytes(b, (const char *)at, length);
        at += length == 0 ? 1 : length;
    }
    buffer_text(b, "\"");
}

void buffer_number(struct buffer *b, double x)
{
    char digits[32];
    if (!isfinite(x)) {
        buffer_text(b, "null");
        return;
    }
    snprintf(digits, sizeof digits, "%.15g", x);
    if (strtod(digits, NULL) != x)
        snprintf(digits, sizeof digits, "%.17g", x);
    buffer_text(b, digits);
}
