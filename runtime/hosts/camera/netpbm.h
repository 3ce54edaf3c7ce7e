/* netpbm.h -- parses the header of a PGM or PPM image. No I/O. */
#ifndef FROB_HOST_CAMERA_NETPBM_H
#define FROB_HOST_CAMERA_NETPBM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum netpbm_result { NETPBM_GOOD, NETPBM_MORE, NETPBM_WRONG };

struct netpbm_head {
    bool is_grey;
    int64_t width, height, most; /* at most 10^8 */
    size_t length;               /* length of the header in bytes; the pixels follow it */
};

/* Parses the header. NETPBM_MORE: more bytes are needed. */
enum netpbm_result netpbm_read(const uint8_t *bytes, size_t size, struct netpbm_head *head);

#endif
