/* tag_finder.h -- finds AprilTags in an image with the AprilTag library.
 *
 * The library is loaded only if a program uses tags, so it need not be installed otherwise. It
 * allocates memory and takes milliseconds, so the host calls it, not the program. With the same
 * version of the library, the same image always yields the same tags. */
#ifndef FROB_HOST_TAG_FINDER_H
#define FROB_HOST_TAG_FINDER_H

#include <frob/tags.h>

#include <stdbool.h>

struct tag_finder {
    void *detector, *family;
    uint8_t *grey; /* buffer for the current image in grey */
    size_t room;
};

/* Prepares to find tags of the family 36h11. If the library is missing, prints a line on standard
 * error and returns false. */
bool tag_finder_open(struct tag_finder *finder);

/* Finds the tags in the image, largest first. If memory runs out, prints a line on standard error
 * and returns false. */
bool tag_finder_find(struct tag_finder *finder, const struct frob_image *image,
                     struct frob_tags *tags);

/* May also be called with a struct that is all zero. */
void tag_finder_close(struct tag_finder *finder);

#endif
