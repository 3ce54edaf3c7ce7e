/* jpeg.h -- where a JPEG picture ends in a stream of bytes. No I/O, no decoding. */
#ifndef FROB_HOST_CAMERA_JPEG_H
#define FROB_HOST_CAMERA_JPEG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* How far a picture has been looked through. It begins with FF D8 at 0. */
struct jpeg_scan {
    size_t at;
    bool in_data; /* within what is compressed, and not in a segment */
};

enum jpeg_result {
    JPEG_MORE,
    JPEG_WHOLE, /* it ends at `at` */
    JPEG_TORN   /* it breaks off at `at`: another one may begin there */
};

/* Goes on with what has come; what was there before must be the same. Linear in what is new. */
enum jpeg_result jpeg_scan(struct jpeg_scan *scan, const uint8_t *bytes, size_t size);

#endif
