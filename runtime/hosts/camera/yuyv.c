#include "yuyv.h"

#include <string.h>

static uint8_t within(int x)
{
    return (uint8_t)(x < 0 ? 0 : x > 255 ? 255 : x);
}

/* ITU-R BT.601 with Y of 16 … 235: R = 1.164 (Y - 16) + 1.596 (V - 128) and so on, in 1/256. */
static void to_rgb(uint8_t *rgb, int y, int u, int v)
{
    const int c = 298 * (y - 16) + 128, d = u - 128, e = v - 128;
    rgb[0] = within((c + 409 * e) / 256);
    rgb[1] = within((c - 100 * d - 208 * e) / 256);
    rgb[2] = within((c + 516 * d) / 256);
}

/* Converts a row. Y0 U Y1 V encode two pixels; a row of odd width ends with a complete pair. */
static void yuyv_row(const uint8_t *in, struct captured *frame, uint8_t *out)
{
    for (int32_t x = 0; x < frame->width; x++) {
        const uint8_t *pair = in + 4 * (x / 2);
        const int y = pair[2 * (x % 2)];
        if (frame->format == FROB_GREY8)
            out[x] = within((298 * (y - 16) + 128) / 256);
        else
            to_rgb(out + 3 * x, y, pair[1], pair[3]);
    }
}

bool yuyv_or_grey(const uint8_t *bytes, size_t size, size_t stride, bool is_yuyv,
                  struct captured *frame)
{
    const size_t width = (size_t)frame->width, height = (size_t)frame->height;
    const size_t row = is_yuyv ? 4 * ((width + 1) / 2) : width;
    const size_t out = width * (size_t)frob_image_pixel_size(frame->format);
    if (stride < row)
        stride = row;
    if (height == 0 || size < stride * (height - 1) + row)
        return false;
    for (size_t y = 0; y < height; y++) {
        if (is_yuyv)
            yuyv_row(bytes + y * stride, frame, frame->pixels + y * out);
        else
            memcpy(frame->pixels + y * out, bytes + y * stride, width);
    }
    return true;
}
