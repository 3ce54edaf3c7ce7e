/* patch.h -- patches, cut out of an image again and again. */
#ifndef FROB_VISION_PATCH_H
#define FROB_VISION_PATCH_H

#include <frob/vision.h>

/* Brightness of a part of an image: in the image itself, or, for colours, in the room once it
 * is made for places around one. */
struct frob_greys {
    const struct frob_image *image;
    int32_t left, top, width, height; /* of what is there as bytes */
    const uint8_t *pixels;
    ptrdiff_t stride;
    uint8_t room[160 * 160];
};

/* Makes ready for patches whose middles are up to `reach` pixels from this place. False if
 * there are no patches to be had: no pixels, or numbers that are none. */
bool frob_greys_around(struct frob_greys *greys, const struct frob_image *image,
                       const struct frob_placement *place, double reach);

/* Fills in the samples, and gives how many have their places in the image. */
int32_t frob_cut_patch(const struct frob_greys *greys, const struct frob_placement *place,
                       double samples[FROB_PATCH_SIZE]);

#endif
