/* patch.h -- cuts several patches out of the same image. */
#ifndef FROB_VISION_PATCH_H
#define FROB_VISION_PATCH_H

#include <frob/vision.h>

/* The brightness of an image around a position. For a grey image, `pixels` points into the image
 * itself. A colour image is converted once, into the buffer `room`. */
struct frob_greys {
    const struct frob_image *image;
    int32_t left, top, width, height; /* the part of the image in `pixels` */
    const uint8_t *pixels;
    ptrdiff_t stride;
    uint8_t room[160 * 160];
};

/* Prepares to cut patches whose centres are at most `reach` pixels from this position. Returns
 * false if there can be no patches: the image has no pixels, or the placement is invalid. */
bool frob_greys_around(struct frob_greys *greys, const struct frob_image *image,
                       const struct frob_placement *place, double reach);

/* Computes the samples, and returns the number of samples whose positions are in the image. */
int32_t frob_cut_patch(const struct frob_greys *greys, const struct frob_placement *place,
                       double samples[FROB_PATCH_SIZE]);

#endif
