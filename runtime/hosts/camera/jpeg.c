#include "jpeg.h"

#include <string.h>

enum { FILL = 0xFF, START = 0xD8, END = 0xD9, SCAN = 0xDA, RESTART = 0xD0, TEM = 0x01 };

/* Returns whether compressed data continues at this marker. ITU-T T.81, B.1: in compressed data, FF
 * is followed by 0 or by a restart marker. */
static bool goes_on(uint8_t marker)
{
    return marker == 0 || (marker >= RESTART && marker < RESTART + 8);
}

enum jpeg_result jpeg_scan(struct jpeg_scan *scan, const uint8_t *bytes, size_t size)
{
    if (scan->at == 0)
        scan->at = 2;
    for (;;) {
        size_t length;
        uint8_t marker;
        if (scan->in_data && scan->at < size) {
            const uint8_t *found = (const uint8_t *)memchr(bytes + scan->at, FILL, size - scan->at);
            scan->at = found == NULL ? size : (size_t)(found - bytes);
        }
        if (size < 2 || scan->at > size - 2)
            return JPEG_MORE;
        if (bytes[scan->at] != FILL)
            return JPEG_TORN;
        marker = bytes[scan->at + 1];
        if (marker == FILL) {
            scan->at++;
            continue;
        }
        if (scan->in_data && goes_on(marker)) {
            scan->at += 2;
            continue;
        }
        if (marker == END) {
            scan->at += 2;
            return JPEG_WHOLE;
        }
        if (marker == START || (!scan->in_data && goes_on(marker) && marker == 0))
            return JPEG_TORN;
        if (goes_on(marker) || marker == TEM) {
            scan->at += 2;
            continue;
        }
        if (size - scan->at < 4)
            return JPEG_MORE;
        length = (size_t)bytes[scan->at + 2] << 8 | bytes[scan->at + 3];
        if (length < 2)
            return JPEG_TORN;
        /* Examines an incomplete segment again when more bytes have arrived. */
        if (size - scan->at - 2 < length)
            return JPEG_MORE;
        scan->at += 2 + length;
        scan->in_data = marker == SCAN;
    }
}
