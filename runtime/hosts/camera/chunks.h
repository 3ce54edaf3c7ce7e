/* chunks.h -- decodes the chunked body of an HTTP response (RFC 9112, 7.1). No I/O. */
#ifndef FROB_HOST_CAMERA_CHUNKS_H
#define FROB_HOST_CAMERA_CHUNKS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct chunks {
    enum { CHUNKS_LENGTH, CHUNKS_REST_OF_LINE, CHUNKS_DATA, CHUNKS_END_OF_DATA, CHUNKS_OVER } state;
    uint64_t left; /* number of bytes left in this chunk or, in state CHUNKS_LENGTH, the length
                    * read so far */
    bool digits;
};

/* Removes everything except the data from these bytes, and returns the length of the data, or -1 if
 * the bytes are not valid chunks. */
ptrdiff_t chunks_take(struct chunks *c, uint8_t *bytes, size_t size);

#endif
