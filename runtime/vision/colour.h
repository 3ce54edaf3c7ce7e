/* colour.h -- finds the pixels of a row that are in a colour range. */
#ifndef FROB_VISION_COLOUR_H
#define FROB_VISION_COLOUR_H

#include "view.h"

/* A colour range, prepared for matching many pixels.
 *
 * The hue test needs no division. A hue is a half-line from the grey axis of the colour cube. The
 * sign of the triple product of the grey axis, the pure colour of that hue and (r, g, b) shows on
 * which side of the half-line the colour (r, g, b) lies. This triple product equals the scalar
 * product from * (r, g, b). */
struct frob_colours {
    /* The first test is "at or after the first hue", the second "at or before the last hue". */
    int16_t from[3], to[3];
    /* A pixel must pass both tests, or one of them if the range is more than half a turn (wide is
     * 1). */
    int16_t wide;
    int16_t pale, strong; /* limits of saturation, 0 … 128 */
    int16_t dark, bright; /* limits of value, 0 … 255; no pixel matches if dark is 256 */
};

struct frob_colours frob_colours_of(const struct frob_colour_range *range);

/* Writes 1 (match) or 0 for each column left … right - 1 of row y. */
void frob_match_row(const struct frob_image *image, int32_t y, int32_t left, int32_t right,
                    const struct frob_colours *colours, uint8_t *mask);

/* Finds the next run in a mask of `count` bytes, starting at *end. The run consists of the
 * columns *start … *end - 1. Returns false if there is none. *end must be 0 before the first
 * call. */
bool frob_next_run(const uint8_t *mask, int32_t count, int32_t *start, int32_t *end);

#endif
