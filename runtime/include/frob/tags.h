/* frob/tags.h -- the tags that a camera sees, as part of a program's input.
 *
 * If a program uses tags (its table has a control of the kind FROB_TAGS), the host looks for them
 * in the camera's frames and passes the tags instead of the image. Therefore the tag finder may
 * allocate memory, and a recording that contains tags can be replayed without the tag finder. */
#ifndef FROB_TAGS_H
#define FROB_TAGS_H

#include <frob/image.h>
#include <frob/program.h>
#include <frob/vision.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { FROB_MOST_TAGS = 8 };

/* The tags in a frame, largest first. Tags of equal size are ordered by number. */
struct frob_tags {
    size_t count; /* 0 … FROB_MOST_TAGS */
    struct frob_tag each[FROB_MOST_TAGS];
};

/* Sets the event for this instant to the tags in the frame and the age of the frame at the time
 * `now_ns`. If there is no frame, `image` and `tags` must both be NULL. */
void frob_tags_give(const struct frob_control *control, void *input, const struct frob_image *image,
                    const struct frob_tags *tags, int64_t now_ns);

#ifdef __cplusplus
}
#endif
#endif
