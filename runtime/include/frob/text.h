/* frob/text.h -- builds text in a buffer that the caller owns.
 *
 * No function allocates memory. Text that does not fit is dropped, and `full` is set. `data` always
 * ends with a NUL. */
#ifndef FROB_TEXT_H
#define FROB_TEXT_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

struct frob_text {
    char *data;
    size_t capacity; /* size of data, with the NUL; at least 1 */
    size_t length;
    bool full; /* whether some text did not fit */
};

/* Returns an empty text in the given buffer. */
struct frob_text frob_text_in(char *buffer, size_t capacity);

void frob_text_clear(struct frob_text *text);
void frob_text_add(struct frob_text *text, const char *string);
void frob_text_add_char(struct frob_text *text, char c);

/* Drops everything after the first `length` characters. */
void frob_text_cut(struct frob_text *text, size_t length);

#ifdef __cplusplus
}
#endif
#endif
