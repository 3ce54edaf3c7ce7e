/* buffer.h -- a growable text buffer, and functions that write JSON to it.
 *
 * If memory runs out, the text that does not fit is dropped, and `failed` is set. */
#ifndef FROB_VIEW_BUFFER_H
#define FROB_VIEW_BUFFER_H

#include <stdbool.h>
#include <stddef.h>

struct buffer {
    char *data; /* ends with a NUL; NULL until something is added */
    size_t length, capacity;
    bool failed;
    bool is_binary; /* for a message: whether it contains more than text */
};

void buffer_clear(struct buffer *b);
void buffer_free(struct buffer *b);

void buffer_bytes(struct buffer *b, const char *bytes, size_t length);
void buffer_text(struct buffer *b, const char *text);
void buffer_format(struct buffer *b, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Adds a JSON string with its quotes. Bytes that are not UTF-8 become U+FFFD. */
void buffer_string(struct buffer *b, const char *text);

/* Adds a JSON number that reads back as the same double; `null` if it is not finite. */
void buffer_number(struct buffer *b, double x);

#endif
