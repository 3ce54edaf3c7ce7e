/* moments.h -- sums over the pixels of a blob. */
#ifndef FROB_VISION_MOMENTS_H
#define FROB_VISION_MOMENTS_H

#include <frob/vision.h>

/* Exact sums, over all pixels, of the column x, the row y, and their squares and product. An image
 * has at most 2^24 pixels (2^12 by 2^12) and a square is at most 2^24, so a sum is at most 2^48. */
struct frob_moments {
    int64_t count, x, y, xx, xy, yy;
    int32_t left, top, right, bottom; /* bounding box, inclusive */
};

/* Returns the moments of the empty set. */
struct frob_moments frob_no_moments(void);

/* Adds the pixels of columns start … end - 1 of a row. */
void frob_add_run(struct frob_moments *moments, int32_t y, int32_t start, int32_t end);

/* Adds another set's moments. */
void frob_add_moments(struct frob_moments *moments, const struct frob_moments *others);

void frob_blob_of(const struct frob_moments *moments, struct frob_blob *result);

#endif
