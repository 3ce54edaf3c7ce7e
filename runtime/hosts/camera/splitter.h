/* splitter.h -- splits a stream of bytes into frames: raw frames, which all have the same size, or
 * images in a self-describing format (PPM, PGM and JPEG), with any bytes between them. No I/O.
 *
 * Bytes between images are skipped, so the splitter resynchronizes after lost bytes. The headers in
 * a multipart stream are skipped in the same way. */
#ifndef FROB_HOST_CAMERA_SPLITTER_H
#define FROB_HOST_CAMERA_SPLITTER_H

#include "jpeg.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct splitter {
    size_t raw_size; /* size of a raw frame in bytes; 0 for images */
    uint8_t *bytes;
    size_t from, to; /* range of the received bytes that have not been consumed yet */
    struct jpeg_scan scan;
    int64_t begun_ns; /* time at which the byte at `from` arrived */
    int64_t fed_ns;
    uint32_t torn; /* number of truncated frames */
};

/* Returns false if memory runs out. */
bool splitter_open(struct splitter *s, size_t raw_size);
void splitter_close(struct splitter *s);

/* Discards all received bytes, for example before a new connection. */
void splitter_forget(struct splitter *s);

/* splitter_space returns where to store the next bytes, and how many bytes fit there. This number
 * is never 0 after all frames have been taken. After storing bytes, call splitter_feed with their
 * number and the current time. */
uint8_t *splitter_space(struct splitter *s, size_t *room);
void splitter_feed(struct splitter *s, size_t count, int64_t now_ns);

/* Returns the next complete frame, or NULL if there is none yet. The frame stays in the splitter's
 * memory until more bytes are fed. */
const uint8_t *splitter_take(struct splitter *s, size_t *size, int64_t *begun_ns);

/* Returns the newest complete frame, and adds the number of older frames that it skips to
 * `skipped`. */
const uint8_t *splitter_take_newest(struct splitter *s, size_t *size, int64_t *begun_ns,
                                    uint32_t *skipped);

#endif
