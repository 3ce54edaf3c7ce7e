/* stereo.h -- computes the disparities of a pair of images row by row. */
#ifndef FROB_VISION_STEREO_H
#define FROB_VISION_STEREO_H

#include "view.h"

/* Sums of differences in a window around each pixel, for each disparity.
 *
 * The arrays contain one number for each column and disparity; all columns of a disparity are
 * consecutive, so that each loop runs along a row. Like Konolige's Small Vision System and OpenCV,
 * the matcher does not compare brightness, which differs between the two cameras, but the gradient
 * along the row, clipped to -31 … 31. */
struct frob_stereo_rows {
    const struct frob_image *left, *right;
    struct frob_view view;
    int32_t width, disparities, around; /* a window has 2 * around + 1 pixels per side */
    int32_t wide;                       /* columns covered by windows: width + 2 * around */
    uint16_t *columns;                  /* disparities x wide: sums over a window's height */
    uint16_t *squares; /* disparities x wide: sums over windows, `width` in each row */
    int32_t texture[FROB_IMAGE_SIDE + 32]; /* sums of the left image's gradients */
};

/* The number of 16-bit integers in the buffer for a region of this width. */
#define FROB_STEREO_ROOM(width, disparities, window) \
    (((size_t)(width) + (window)) * 2 * (size_t)(disparities))

/* Divides the buffer into the arrays, and adds up the rows above the first one. Returns false if
 * the images cannot be matched: a format is unsuitable, the sizes differ, the view is empty, or the
 * buffer is too small. */
bool frob_stereo_begin(struct frob_stereo_rows *rows, const struct frob_image *left,
                       const struct frob_image *right, const struct frob_stereo *how,
                       uint16_t *room, size_t room_size);

/* Computes the disparities of row y of the view, in 1/16 pixels; -1 if unknown. Must be called for
 * all rows in order, from the first to the last. */
void frob_stereo_row(struct frob_stereo_rows *rows, int32_t y, int16_t *disparities);

#endif
