/* view.h -- the part of an image that a kernel looks at. */
#ifndef FROB_VISION_VIEW_H
#define FROB_VISION_VIEW_H

#include <frob/vision.h>

/* Columns left … right - 1, rows top … bottom - 1, all of them in the image; neither is empty
 * unless both are. */
struct frob_view {
    int32_t left, top, right, bottom;
};

/* What of the region is in the image; nothing if that is not sound. */
struct frob_view frob_view_of(const struct frob_image *image, const struct frob_region *roi);

/* Brightness of the columns left … right - 1 of a row of a grey or colour image: in the image
 * itself or, where it has to be computed, in the room. */
const uint8_t *frob_grey_row(const struct frob_image *image, int32_t y, int32_t left, int32_t right,
                             uint8_t *room);

/* Brightness at a place between pixels, of a grey or colour image with pixels: by the four
 * around it, or as at the border beyond that. */
double frob_grey_at(const struct frob_image *image, double x, double y);

#endif
