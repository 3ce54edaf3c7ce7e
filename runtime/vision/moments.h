/* moments.h -- what is summed over the pixels of a blob. */
#ifndef FROB_VISION_MOMENTS_H
#define FROB_VISION_MOMENTS_H

#include <frob/vision.h>

/* Sums over columns and rows of pixels, exact: 2^24 pixels of an image of 2^12 by 2^12, whose
 * squares are 2^24, make 2^48. */
struct frob_moments {
    int64_t count, x, y, xx, xy, yy;
    int32_t left, top, right, bottom; /* of all pixels, the ends inside */
};

/* Of no pixel. */
struct frob_moments frob_no_moments(void);

/* Adds the pixels of columns start … end - 1 of a row. */
void frob_add_run(struct frob_moments *moments, int32_t y, int32_t start, int32_t end);

/* Adds what another has. */
void frob_add_moments(struct frob_moments *moments, const struct frob_moments *others);

void frob_blob_of(const struct frob_moments *moments, struct frob_blob *result);

#endif
