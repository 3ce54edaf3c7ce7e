/* splitter.h -- a stream of bytes to frames: raw ones, which have all the same size, or pictures
 * that tell their form themselves, PPM, PGM and JPEG, with anything between JPEGs. No I/O.
 *
 * Between pictures other bytes are skipped, so a stream that lost some finds its way again; also
 * the heads of a multipart stream are nothing else. */
#ifndef FROB_HOST_CAMERA_SPLITTER_H
#define FROB_HOST_CAMERA_SPLITTER_H

#include "jpeg.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct splitter {
    size_t raw_size; /* bytes of a raw frame; 0: pictures */
    uint8_t *bytes;
    size_t from, to; /* what has come and is not used up */
    struct jpeg_scan scan;
    int64_t begun_ns; /* when the first byte at `from` came */
    int64_t fed_ns;
    uint32_t torn; /* frames that broke off */
};

/* False without memory. */
bool splitter_open(struct splitter *s, size_t raw_size);
void splitter_close(struct splitter *s);

/* What has come belongs to nothing that will come. */
void splitter_forget(struct splitter *s);

/* Where bytes are to be put that come next, and how many may; never 0 after all frames have been
 * taken. Then how many have come, and when. */
uint8_t *splitter_space(struct splitter *s, size_t *room);
void splitter_feed(struct splitter *s, size_t count, int64_t now_ns);

/* A whole frame, in the splitter's memory until it is given bytes again; NULL if there is none
 * yet. */
const uint8_t *splitter_take(struct splitter *s, size_t *size, int64_t *begun_ns);

/* The last of those that are whole; `skipped` goes up by those before it. */
const uint8_t *splitter_take_newest(struct splitter *s, size_t *size, int64_t *begun_ns,
                                    uint32_t *skipped);

#endif
