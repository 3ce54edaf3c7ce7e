/* stereo.h -- disparities of a pair of images, row by row. */
#ifndef FROB_VISION_STEREO_H
#define FROB_VISION_STEREO_H

#include "view.h"

/* Sums of differences in a square around each pixel, for each disparity.
 *
 * Arrays of one number for each column and disparity, all columns of a disparity together, so
 * that each loop runs along a row. `between` is what Konolige's small vision system matched,
 * and OpenCV does: not brightness, which two cameras see differently, but how it changes
 * along the row, cut off at 31 either way. */
struct frob_stereo_rows {
    const struct frob_image *left, *right;
    struct frob_view view;
    int32_t width, disparities, around;    /* the square's side is 2 around + 1 */
    int32_t wide;                          /* columns that squares reach, width + 2 around */
    uint16_t *columns;                     /* disparities x wide: sums down a square's height */
    uint16_t *squares;                     /* disparities x wide: sums of squares, of `width` */
    int32_t texture[FROB_IMAGE_SIDE + 32]; /* how much the left image changes down there */
};

/* Numbers of 16 bits in the room for so many columns. */
#define FROB_STEREO_ROOM(width, disparities, window) \
    (((size_t)(width) + (window)) * 2 * (size_t)(disparities))

/* Where in the room what is, and the rows above the first one. False if there is nothing to
 * match: formats, sizes or a view without pixels. */
bool frob_stereo_begin(struct frob_stereo_rows *rows, const struct frob_image *left,
                       const struct frob_image *right, const struct frob_stereo *how,
                       uint16_t *room, size_t room_size);

/* The disparities of row y of the view, in 1/16 pixels; -1 where they are not known. Rows are
 * asked for from the first to the last. */
void frob_stereo_row(struct frob_stereo_rows *rows, int32_t y, int16_t *disparities);

#endif
