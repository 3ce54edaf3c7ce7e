/* chunks.h -- decodes the chunked body of an HTTP response (RFC 9112, 7.1). No I/O. */
#ifndef FROB_HOST_CAMERA_CHUNKS_H
#define FROB_HOST_CAMERA_CHUNKS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct chunks {
    enum { CHUNKS_LENGTH, CHUNKS_REST_OF_LINE, CHUNKS_DATA, CHUNKS_END_OF_DATA, CHUNKS_OVER } state;
    uint64_t left; /* bytes left in this chunk; in state CHUNKS_LENGTH, the length read so far */
    bool digits;
};

/* Moves the data among these bytes to their beginning, and returns its length; -1 if the bytes are
 * not chunks. */
ptrdiff_t chunks_take(struct chunks *c, uint8_t *bytes, size_t size);

#endif
