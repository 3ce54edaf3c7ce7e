#include "chunks.h"

#include <string.h>

static int digit(uint8_t c)
{
    if (c >= '0' && c <= '9')
        return c - '0';
    c |= 0x20;
    return c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

/* Handles a byte of the line that contains the chunk's length. Returns false if the byte is
 * invalid there. */
static bool length(struct chunks *c, uint8_t byte)
{
    const int d = digit(byte);
    if (byte == '\n' || byte == '\r' || byte == ';' || byte == ' ') {
        if (!c->digits)
            return false;
        c->state = byte == '\n' ? CHUNKS_DATA : CHUNKS_REST_OF_LINE;
    } else if (d < 0 || c->left >> 56 != 0) {
        return false;
    } else {
        c->left = c->left << 4 | (unsigned)d;
        c->digits = true;
    }
    return true;
}

ptrdiff_t chunks_take(struct chunks *c, uint8_t *bytes, size_t size)
{
    size_t from = 0, to = 0;
    while (from < size) {
        size_t count;
        switch (c->state) {
        case CHUNKS_LENGTH:
            if (!length(c, bytes[from++]))
                return -1;
            break;
        case CHUNKS_REST_OF_LINE:
            if (bytes[from++] == '\n')
                c->state = CHUNKS_DATA;
            break;
        case CHUNKS_DATA:
            count = size - from < c->left ? size - from : (size_t)c->left;
            memmove(bytes + to, bytes + from, count);
            from += count;
            to += count;
            c->left -= count;
            if (c->left == 0)
                c->state = count == 0 ? CHUNKS_OVER : CHUNKS_END_OF_DATA;
            break;
        case CHUNKS_END_OF_DATA:
            if (bytes[from] == '\n') {
                c->state = CHUNKS_LENGTH;
                c->digits = false;
            } else if (bytes[from] != '\r') {
                return -1;
            }
            from++;
            break;
        case CHUNKS_OVER: return (ptrdiff_t)to;
        }
    }
    return (ptrdiff_t)to;
}
