#include "decode.h"
#include "turbo.h"

#include <stdio.h>
#include <string.h>

/* Returns whether the image is complete despite libjpeg's warning: many cameras leave some bytes
 * between the compressed data and the end marker. */
static bool is_harmless(const char *warning)
{
    return strstr(warning, "extraneous bytes before marker") != NULL;
}

static const char *decode(const struct turbo *turbo, void *handle, const uint8_t *bytes,
                          size_t size, bool is_grey, struct captured *frame, char message[256])
{
    int width = 0, height = 0, samples = 0, space = 0;
    const char *fault;
    if (turbo->header(handle, bytes, (unsigned long)size, &width, &height, &samples, &space) != 0) {
        snprintf(message, 256, "a frame is not a JPEG: %s", turbo->error(handle));
        return message;
    }
    if (width < 1 || height < 1)
        return "a frame is not a JPEG: it ends before the header that contains its size";
    is_grey = is_grey || samples == TURBO_SAMPLES_GREY;
    fault = decode_set_size(frame, width, height, is_grey ? FROB_GREY8 : FROB_RGB8, message);
    if (fault != NULL)
        return fault;
    if (turbo->decompress(handle, bytes, (unsigned long)size, frame->pixels, width, 0, height,
                          is_grey ? TURBO_GREY : TURBO_RGB, TURBO_ACCURATE) != 0 &&
        !is_harmless(turbo->error(handle))) {
        snprintf(message, 256, "a JPEG is damaged: %s", turbo->error(handle));
        return message;
    }
    return NULL;
}

/* Decodes a JPEG image. If decoding fails, replaces the decompressor, because a damaged header
 * leaves it in an invalid state for the next frame. */
const char *decode_jpeg(const uint8_t *bytes, size_t size, bool is_grey, struct captured *frame,
                        char message[256])
{
    static void *handle = NULL;
    const char *fault = NULL;
    const struct turbo *turbo = turbo_find(&fault);
    if (turbo == NULL)
        return fault;
    if (handle == NULL && (handle = turbo->init_decompress()) == NULL)
        return "not enough memory to read a JPEG";
    fault = decode(turbo, handle, bytes, size, is_grey, frame, message);
    if (fault != NULL) {
        turbo->destroy(handle);
        handle = NULL;
    }
    return fault;
}
