#include "splitter.h"

#include "buffers.h"
#include "netpbm.h"

#include <stdlib.h>
#include <string.h>

/* The space for the largest frame and its header. A JPEG is never larger than its uncompressed
 * image. */
#define ROOM (BUFFERS_ROOM + (64u << 10))

bool splitter_open(struct splitter *s, size_t raw_size)
{
    memset(s, 0, sizeof *s);
    s->raw_size = raw_size;
    s->bytes = (uint8_t *)malloc(ROOM);
    return s->bytes != NULL;
}

void splitter_close(struct splitter *s)
{
    free(s->bytes);
    s->bytes = NULL;
}

static void use_up(struct splitter *s, size_t count)
{
    s->from += count;
    s->scan.at = 0;
    s->scan.in_data = false;
    s->begun_ns = s->fed_ns;
}

void splitter_forget(struct splitter *s)
{
    s->from = s->to = 0;
    use_up(s, 0);
}

uint8_t *splitter_space(struct splitter *s, size_t *room)
{
    if (s->from > 0) {
        memmove(s->bytes, s->bytes + s->from, s->to - s->from);
        s->to -= s->from;
        s->from = 0;
    }
    if (s->to == ROOM) { /* the data is too long to be a frame */
        s->torn++;
        s->to = 0;
        use_up(s, 0);
    }
    *room = ROOM - s->to;
    return s->bytes + s->to;
}

void splitter_feed(struct splitter *s, size_t count, int64_t now_ns)
{
    if (s->from == s->to)
        s->begun_ns = now_ns;
    s->fed_ns = now_ns;
    s->to += count;
}

/* Returns whether the bytes, which may be incomplete, can start a JPEG: FF D8, and the FF of the
 * next segment. */
static bool may_be_jpeg(const uint8_t *bytes, size_t size)
{
    static const uint8_t begin[] = { 0xFF, 0xD8, 0xFF };
    return memcmp(bytes, begin, size < sizeof begin ? size : sizeof begin) == 0;
}

/* Skips bytes that cannot start an image. */
static void find_begin(struct splitter *s)
{
    struct netpbm_head head;
    size_t at = s->from;
    while (at < s->to && !may_be_jpeg(s->bytes + at, s->to - at) &&
           netpbm_read(s->bytes + at, s->to - at, &head) == NETPBM_WRONG)
        at++;
    if (at > s->from)
        use_up(s, at - s->from);
}

static const uint8_t *take(struct splitter *s, size_t count, size_t *size, int64_t *begun_ns)
{
    const uint8_t *frame = s->bytes + s->from;
    *size = count;
    *begun_ns = s->begun_ns;
    use_up(s, count);
    return frame;
}

const uint8_t *splitter_take(struct splitter *s, size_t *size, int64_t *begun_ns)
{
    struct netpbm_head head;
    if (s->raw_size > 0)
        return s->to - s->from >= s->raw_size ? take(s, s->raw_size, size, begun_ns) : NULL;
    for (;;) {
        find_begin(s);
        if (s->to - s->from < 3)
            return NULL;
        if (s->bytes[s->from] == 'P') {
            size_t whole;
            if (netpbm_read(s->bytes + s->from, s->to - s->from, &head) != NETPBM_GOOD)
                return NULL;
            whole = head.length + (size_t)head.width * (size_t)head.height * (head.is_grey ? 1 : 3);
            if (head.width > FROB_IMAGE_SIDE || head.height > FROB_IMAGE_SIDE || whole > ROOM) {
                /* If the image is too large, return only its header; the decoder reports the
                 * error. */
                return take(s, head.length, size, begun_ns);
            }
            return s->to - s->from >= whole ? take(s, whole, size, begun_ns) : NULL;
        }
        switch (jpeg_scan(&s->scan, s->bytes + s->from, s->to - s->from)) {
        case JPEG_WHOLE: return take(s, s->scan.at, size, begun_ns);
        case JPEG_MORE: return NULL;
        case JPEG_TORN:
            s->torn++;
            use_up(s, s->scan.at);
            break;
        }
    }
}

const uint8_t *splitter_take_newest(struct splitter *s, size_t *size, int64_t *begun_ns,
                                    uint32_t *skipped)
{
    const uint8_t *frame = NULL, *newer;
    size_t newer_size;
    int64_t newer_ns;
    while ((newer = splitter_take(s, &newer_size, &newer_ns)) != NULL) {
        if (frame != NULL)
            (*skipped)++;
        frame = newer;
        *size = newer_size;
        *begun_ns = newer_ns;
    }
    return frame;
}
