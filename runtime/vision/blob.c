/* blob.c -- finds all pixels in a colour range, as one blob. */
#include "colour.h"
#include "moments.h"

void frob_find_blob(const struct frob_image *image, const struct frob_region *roi,
                    const struct frob_colour_range *colours, struct frob_blob *result)
{
    const struct frob_view view = frob_view_of(image, roi);
    const struct frob_colours made = frob_colours_of(colours);
    struct frob_moments moments = frob_no_moments();
    uint8_t mask[FROB_IMAGE_SIDE];

    for (int32_t y = view.top; y < view.bottom; y++) {
        int32_t start = 0, end = 0;
        frob_match_row(image, y, view.left, view.right, &made, mask);
        while (frob_next_run(mask, view.right - view.left, &start, &end))
            frob_add_run(&moments, y, view.left + start, view.left + end);
    }
    frob_blob_of(&moments, result);
}
