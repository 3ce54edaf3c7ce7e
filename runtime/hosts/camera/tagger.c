#include "tagger.h"

#include <string.h>
#include <unistd.h>

/* BEGIN_MS: maximum delay until the capture process learns that the program has begun. */
enum { WAIT_MS = 100, BEGIN_MS = 5 };

static struct frob_image image_of(const struct captured *frame)
{
    struct frob_image image;
    memset(&image, 0, sizeof image);
    image.width = frame->width;
    image.height = frame->height;
    image.format = frame->format;
    image.stride = frame->width * frob_image_pixel_size(frame->format);
    image.pixels = frame->pixels;
    return image;
}

static void copy(struct captured *to, const struct captured *from)
{
    const struct frob_image image = image_of(from);
    uint8_t *pixels = to->pixels;
    *to = *from;
    to->pixels = pixels;
    memcpy(pixels, from->pixels, (size_t)image.stride * (size_t)image.height);
}

void tagger_run(struct tag_finder *finder, struct buffers *seen, struct buffers *given)
{
    for (;;) {
        const bool has_begun = buffers_have_begun(given);
        const struct captured *frame;
        buffers_beat(given);
        if (has_begun)
            buffers_begin(seen);
        buffers_wait(seen, has_begun ? WAIT_MS : BEGIN_MS);
        frame = buffers_take(seen);
        if (frame != NULL) {
            struct captured *next = buffers_back(given);
            const struct frob_image image = image_of(frame);
            copy(next, frame);
            if (!tag_finder_find(finder, &image, &next->tags))
                _exit(1);
            buffers_publish(given);
        }
    }
}
