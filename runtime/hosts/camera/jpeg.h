/* jpeg.h -- finds the end of a JPEG image in a stream of bytes. No I/O, no decoding. */
#ifndef FROB_HOST_CAMERA_JPEG_H
#define FROB_HOST_CAMERA_JPEG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The progress of scanning an image that starts with FF D8 at offset 0. */
struct jpeg_scan {
    size_t at;
    bool in_data; /* whether the scan is in compressed data rather than in a segment */
};

enum jpeg_result {
    JPEG_MORE,
    JPEG_WHOLE, /* a whole image, which ends before offset `at` */
    JPEG_TORN   /* the image is truncated at `at`, where another one may start */
};

/* Continues scanning with the new bytes; the bytes before them must be unchanged. The time is
 * linear in the number of new bytes. */
enum jpeg_result jpeg_scan(struct jpeg_scan *scan, const uint8_t *bytes, size_t size);

#endif
