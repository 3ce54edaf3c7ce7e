#include "occluded.h"

#include <frob/image.h>

#include <string.h>

/* One buffer is enough: only one frame is used at a time, and none is kept. */
static unsigned char grey[4096 * 3 * 1024];
static struct frob_image hidden;

const struct frob_image *covered(const struct frob_image *image, bool hides)
{
    if (!hides)
        return image;
    memset(grey, 127, sizeof grey);
    hidden = *image;
    hidden.pixels = grey;
    return &hidden;
}
