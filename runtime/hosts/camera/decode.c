#include "decode.h"

#include <stdio.h>
#include <string.h>

size_t decode_raw_size(const struct camera_options *o)
{
    const double *s = o->settings;
    return (size_t)s[CAMERA_WIDTH] * (size_t)s[CAMERA_HEIGHT] * (s[CAMERA_GREY] > 0.0 ? 1 : 3);
}

const char *decode_set_size(struct captured *frame, int64_t width, int64_t height,
                            enum frob_image_format format, char message[256])
{
    if (width < 1 || height < 1 || width > FROB_IMAGE_SIDE || height > FROB_IMAGE_SIDE ||
        (size_t)width * (size_t)height * (size_t)frob_image_pixel_size(format) > BUFFERS_ROOM) {
        snprintf(message, 256,
                 "a frame has %lld x %lld pixels, but the maximum is 1920 x 1200: configure the "
                 "camera to send smaller frames",
                 (long long)width, (long long)height);
        return message;
    }
    frame->width = (int32_t)width;
    frame->height = (int32_t)height;
    frame->format = format;
    frame->has_camera = false;
    return NULL;
}

/* ITU-R BT.601: 0.299 R + 0.587 G + 0.114 B, in 1/256. */
void decode_to_grey(struct captured *frame)
{
    const size_t count = (size_t)frame->width * (size_t)frame->height;
    const uint8_t *p = frame->pixels;
    if (frame->format != FROB_RGB8)
        return;
    for (size_t i = 0; i < count; i++, p += 3)
        frame->pixels[i] = (uint8_t)((77u * p[0] + 150u * p[1] + 29u * p[2] + 128u) >> 8);
    frame->format = FROB_GREY8;
}

const char *decode_picture(const uint8_t *bytes, size_t size, bool is_grey, struct captured *frame,
                           char message[256])
{
    const char *fault;
    if (size >= 2 && bytes[0] == 0xFF && bytes[1] == 0xD8)
        return decode_jpeg(bytes, size, is_grey, frame, message);
    fault = decode_netpbm(bytes, size, frame, message);
    if (fault == NULL && is_grey)
        decode_to_grey(frame);
    return fault;
}
