/* chunks.h -- the body of an HTTP answer that comes in chunks (RFC 9112, 7.1), without the lengths
 * between them. No I/O. */
#ifndef FROB_HOST_CAMERA_CHUNKS_H
#define FROB_HOST_CAMERA_CHUNKS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct chunks {
    enum { CHUNKS_LENGTH, CHUNKS_REST_OF_LINE, CHUNKS_DATA, CHUNKS_END_OF_DATA, CHUNKS_OVER } state;
    uint64_t left; /* of this chunk; while it is read, its length */
    bool digits;
};

/* Moves what is data of these bytes to their beginning; how many those are. -1: they are no
 * chunks. */
ptrdiff_t chunks_take(struct chunks *c, uint8_t *bytes, size_t size);

#endif
