#include "netpbm.h"

#include "decode.h"

#include <frob/frame.h>

#include <stdio.h>
#include <string.h>

enum { MOST_HEAD = 8192, MOST_NUMBER = 100000000 };

static bool is_blank(uint8_t c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
}

/* Skips whitespace and comments, and reads the number after them. */
static enum netpbm_result read_number(const uint8_t *bytes, size_t size, size_t *at, int64_t *x)
{
    bool digits = false;
    *x = 0;
    while (*at < size && (is_blank(bytes[*at]) || bytes[*at] == '#')) {
        if (bytes[*at] == '#')
            while (*at < size && bytes[*at] != '\n')
                (*at)++;
        else
            (*at)++;
    }
    for (; *at < size && bytes[*at] >= '0' && bytes[*at] <= '9'; (*at)++) {
        *x = 10 * *x + (bytes[*at] - '0');
        digits = true;
        if (*x > MOST_NUMBER)
            return NETPBM_WRONG;
    }
    if (*at == size)
        return size > MOST_HEAD ? NETPBM_WRONG : NETPBM_MORE;
    return digits ? NETPBM_GOOD : NETPBM_WRONG;
}

enum netpbm_result netpbm_read(const uint8_t *bytes, size_t size, struct netpbm_head *head)
{
    int64_t *const numbers[] = { &head->width, &head->height, &head->most };
    size_t at = 2;
    if (size < 3)
        return size == 0 || bytes[0] == 'P' ? NETPBM_MORE : NETPBM_WRONG;
    if (bytes[0] != 'P' || (bytes[1] != '5' && bytes[1] != '6') || !is_blank(bytes[2]))
        return NETPBM_WRONG;
    head->is_grey = bytes[1] == '5';
    for (size_t i = 0; i < 3; i++) {
        const enum netpbm_result result = read_number(bytes, size, &at, numbers[i]);
        if (result != NETPBM_GOOD)
            return result;
    }
    if (!is_blank(bytes[at]))
        return NETPBM_WRONG;
    head->length = at + 1;
    return NETPBM_GOOD;
}

const char *decode_netpbm(const uint8_t *bytes, size_t size, struct captured *frame,
                          char message[256])
{
    struct netpbm_head head;
    struct frob_image own;
    const char *fault;
    size_t pixels;
    if (netpbm_read(bytes, size, &head) != NETPBM_GOOD)
        return "a frame has an unknown format: use PPM (P6), PGM (P5) or JPEG";
    if (head.most != 255)
        return "a picture does not have 8 bits per channel: its maximum value must be 255";
    fault = decode_set_size(frame, head.width, head.height, head.is_grey ? FROB_GREY8 : FROB_RGB8,
                            message);
    if (fault != NULL)
        return fault;
    pixels = (size_t)head.width * (size_t)head.height * (head.is_grey ? 1 : 3);
    if (size - head.length < pixels)
        return "a frame is truncated";
    memcpy(frame->pixels, bytes + head.length, pixels);
    if (frob_frame_read(bytes, head.length + pixels, &own) == NULL && own.camera.focal_x > 0.0 &&
        own.camera.focal_y > 0.0) {
        frame->has_camera = true;
        frame->camera = own.camera;
    }
    return NULL;
}
