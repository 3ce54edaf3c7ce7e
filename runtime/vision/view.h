/* view.h -- the part of an image that a kernel examines. */
#ifndef FROB_VISION_VIEW_H
#define FROB_VISION_VIEW_H

#include <frob/vision.h>

/* Columns left … right - 1, rows top … bottom - 1, all within the image. If one range is empty, so
 * is the other. */
struct frob_view {
    int32_t left, top, right, bottom;
};

/* Returns the part of the region within the image; empty if frob_image_is_sound returns false. */
struct frob_view frob_view_of(const struct frob_image *image, const struct frob_region *roi);

/* Returns the brightness of the columns left … right - 1 of a row of a grey or colour image: a
 * pointer into the image itself, or into the buffer `room` if the brightness must be computed. */
const uint8_t *frob_grey_row(const struct frob_image *image, int32_t y, int32_t left, int32_t right,
                             uint8_t *room);

/* Returns the brightness at a position between pixels of a grey or colour image: interpolated from
 * the four pixels around it. Outside the image, it is the brightness at the border. The image must
 * have pixels. */
double frob_grey_at(const struct frob_image *image, double x, double y);

#endif
