#include "drivers/create/stream.h"

#include <string.h>

bool frob_create_stream_init(struct frob_create_stream *stream, const uint8_t *ids, size_t count,
                             bool header_in_sum)
{
    size_t size = 3;
    memset(stream, 0, sizeof *stream);
    if (count == 0 || count > FROB_CREATE_MAX_IDS)
        return false;
    for (size_t i = 0; i < count; i++) {
        if (frob_create_packet_size(ids[i]) == 0)
            return false;
        size += 1 + frob_create_packet_size(ids[i]);
        stream->ids[i] = ids[i];
    }
    if (size > FROB_CREATE_MAX_FRAME)
        return false;
    stream->id_count = (uint8_t)count;
    stream->frame_size = (uint8_t)size;
    stream->header_in_sum = header_in_sum;
    return true;
}

void frob_create_stream_clear(struct frob_create_stream *stream)
{
    memset(stream->window, 0, sizeof stream->window);
    stream->next = 0;
    stream->sum = 0;
}

/* Copies the last frame_size bytes out of the ring. */
static void copy_frame(const struct frob_create_stream *stream, uint8_t *frame)
{
    size_t first = (uint8_t)(stream->next - stream->frame_size);
    size_t before_end = sizeof stream->window - first;
    if (before_end >= stream->frame_size) {
        memcpy(frame, stream->window + first, stream->frame_size);
    } else {
        memcpy(frame, stream->window + first, before_end);
        memcpy(frame + before_end, stream->window, stream->frame_size - before_end);
    }
}

bool frob_create_stream_receive(struct frob_create_stream *stream, uint8_t byte,
                                struct frob_create_sensors *sensors)
{
    uint8_t frame[FROB_CREATE_MAX_FRAME];
    uint8_t first = (uint8_t)(stream->next - stream->frame_size);
    size_t place;
    stream->sum = (uint8_t)(stream->sum + byte - stream->window[first]);
    stream->window[stream->next++] = byte;
    first++;
    if (stream->window[first] != FROB_CREATE_HEADER ||
        stream->window[(uint8_t)(first + 1)] != stream->frame_size - 3 ||
        stream->sum != (stream->header_in_sum ? 0 : FROB_CREATE_HEADER))
        return false;
    copy_frame(stream, frame);
    place = 2;
    for (size_t i = 0; i < stream->id_count; i++) {
        if (frame[place] != stream->ids[i])
            return false;
        place += 1 + frob_create_packet_size(stream->ids[i]);
    }
    place = 2;
    for (size_t i = 0; i < stream->id_count; i++) {
        frob_create_read_packet(stream->ids[i], frame + place + 1, sensors);
        place += 1 + frob_create_packet_size(stream->ids[i]);
    }
    return true;
}
