/* frob/vision.h -- what can be found in an image: the kernels of runtime/vision, as the
 * library's module Vision imports them, and for C of the user's own.
 *
 * Each looks at the pixels once or a few times, in time bounded by the image's size, or by
 * that of what is asked for. Nothing allocates, nothing is kept; the stack is at most
 * 40 kB, of frob_find_blobs 250 kB. The same image gives the same bits on every machine: whole
 * numbers where they do, and IEEE doubles, in an order that is written down, elsewhere.
 *
 * Any argument is safe, NaN too. An image that is not sound (frob_image_is_sound) has no
 * pixels, a region may reach out of it, and where there is nothing to find the result says
 * so. Names are those of OpenMV where it has the thing.
 *
 * Coordinates are those of frob/image.h; angles in radians from the x axis towards the y
 * axis, so clockwise as one looks at the picture. Brightness is grey, 0 … 255; of colours
 * it is (77 red + 150 green + 29 blue) / 256, rounded. */
#ifndef FROB_VISION_H
#define FROB_VISION_H

#include <frob/image.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The structs of Frob's records, with their fields' names; generated headers have the same. */

/* The pixels whose middles are at x … x + width, without the latter, and likewise y. */
#ifndef FROB_REGION_DEFINED
#define FROB_REGION_DEFINED
struct frob_region {
    double x, y, width, height;
};
#endif

/* Colours by hue, saturation and value; both ends are inside. Hue is an angle, red 0, green
 * 120 degrees, blue 240, as by the colours' hexagon; it goes upwards from hueFrom to hueTo, so
 * from 350 to 10 degrees is red; a turn or more is every hue, and grey has every hue.
 * Saturation and value are 0 … 1. Hue is rounded to half a degree, saturation to 1/128. */
#ifndef FROB_COLOUR_RANGE_DEFINED
#define FROB_COLOUR_RANGE_DEFINED
struct frob_colour_range {
    double hueFrom, hueTo, saturationFrom, saturationTo, valueFrom, valueTo;
};
#endif

/* A set of pixels: how many, their mean place, the smallest region around them, and of the
 * ellipse with the same second moments the lengths of both axes and the direction of the
 * major one, above -pi/2 … pi/2. All 0 if there is no pixel. */
#ifndef FROB_BLOB_DEFINED
#define FROB_BLOB_DEFINED
struct frob_blob {
    int32_t pixels;
    double cx, cy;
    struct frob_region box;
    double major, minor, rotation;
};
#endif

/* As many of the largest as were found, largest first, of equal ones the upper one; the rest
 * is 0. */
#ifndef FROB_BLOBS_DEFINED
#define FROB_BLOBS_DEFINED
struct frob_blobs {
    int32_t count;
    struct frob_blob largest[8];
};
#endif

/* All pixels of the region that have such a colour, as one blob. A grey image has colours
 * without saturation, one of depths none. */
void frob_find_blob(const struct frob_image *image, const struct frob_region *roi,
                    const struct frob_colour_range *colours, struct frob_blob *result);

/* The largest sets of such pixels that hang together, by sides or corners. Sets that end
 * above the row that is looked at are done with, so memory is bounded by the width. */
void frob_find_blobs(const struct frob_image *image, const struct frob_region *roi,
                     const struct frob_colour_range *colours, struct frob_blobs *result);

#ifdef __cplusplus
}
#endif
#endif
