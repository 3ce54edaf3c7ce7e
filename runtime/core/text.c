#include <frob/text.h>

struct frob_text frob_text_in(char *buffer, size_t capacity)
{
    struct frob_text text = { buffer, capacity, 0, false };
    buffer[0] = '\0';
    return text;
}

void frob_text_clear(struct frob_text *text)
{
    frob_text_cut(text, 0);
    text->full = false;
}

void frob_text_add_char(struct frob_text *text, char c)
{
    if (text->length + 1 >= text->capacity) {
        text->full = true;
        return;
    }
    text->data[text->length++] = c;
    text->data[text->length] = '\0';
}

void frob_text_add(struct frob_text *text, const char *string)
{
    for (; *string != '\0'; string++)
        frob_text_add_char(text, *string);
}

void frob_text_cut(struct frob_text *text, size_t length)
{
    if (length < text->length) {
        text->length = length;
        text->data[length] = '\0';
    }
}
