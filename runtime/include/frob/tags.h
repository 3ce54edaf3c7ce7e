/* frob/tags.h -- the tags that a camera sees, as part of a program's input.
 *
 * A host looks for them in a camera's frames where a program asks for them (its table has a
 * control of the kind FROB_TAGS) and gives what it has found, not the picture: so what finds them
 * may allocate, and a recording that has them is replayed without it. */
#ifndef FROB_TAGS_H
#define FROB_TAGS_H

#include <frob/image.h>
#include <frob/program.h>
#include <frob/vision.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { FROB_MOST_TAGS = 8 };

/* In a frame: the largest first, of equals the one with the smaller number. */
struct frob_tags {
    size_t count; /* 0 … FROB_MOST_TAGS */
    struct frob_tag each[FROB_MOST_TAGS];
};

/* The event of this instant: what is in the frame, with its age at the time `now_ns`; NULL for
 * both if there is none. */
void frob_tags_give(const struct frob_control *control, void *input, const struct frob_image *image,
                    const struct frob_tags *tags, int64_t now_ns);

#ifdef __cplusplus
}
#endif
#endif
