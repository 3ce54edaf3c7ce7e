/* tag_finder.h -- AprilTags in an image, by the library of that name.
 *
 * It is loaded when a program asks for tags, and not before: whoever has no such program need not
 * have it. It allocates, and takes milliseconds: for hosts, not for programs. The same image and
 * library give the same tags. */
#ifndef FROB_HOST_TAG_FINDER_H
#define FROB_HOST_TAG_FINDER_H

#include <frob/tags.h>

#include <stdbool.h>

struct tag_finder {
    void *detector, *family;
    uint8_t *grey; /* of the image that is looked at */
    size_t room;
};

/* For tags of the family 36h11. False, with a line on standard error, without the library. */
bool tag_finder_open(struct tag_finder *finder);

/* What is in the image, the largest first. False, with a line, without memory. */
bool tag_finder_find(struct tag_finder *finder, const struct frob_image *image,
                     struct frob_tags *tags);

/* Of one that is all zeros, too. */
void tag_finder_close(struct tag_finder *finder);

#endif
