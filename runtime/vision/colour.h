/* colour.h -- which pixels of a row have a colour in a range. */
#ifndef FROB_VISION_COLOUR_H
#define FROB_VISION_COLOUR_H

#include "view.h"

/* A range made for looking at many pixels.
 *
 * Hue needs no division: a hue is a half-line from the grey axis of the colour cube, and on
 * which side of it (r, g, b) is tells the sign of the triple product with the axis and the
 * pure colour of that hue, which is from * (r, g, b). */
struct frob_colours {
    int16_t from[3], to[3]; /* a pixel is at or past the first hue, at or before the last, … */
    int16_t wide;           /* … both, or, if the range is more than half a turn, one of it */
    int16_t pale, strong;   /* saturation, of 128 */
    int16_t dark, bright;   /* value, of 255; no pixel if dark is 256 */
};

struct frob_colours frob_colours_of(const struct frob_colour_range *range);

/* Writes 1 or 0 for each column left … right - 1 of row y. */
void frob_match_row(const struct frob_image *image, int32_t y, int32_t left, int32_t right,
                    const struct frob_colours *colours, uint8_t *mask);

/* The next run of a mask of `count` bytes, from *end on: false if there is none, else columns
 * *start … *end - 1. Before the first call *end is 0. */
bool frob_next_run(const uint8_t *mask, int32_t count, int32_t *start, int32_t *end);

#endif
