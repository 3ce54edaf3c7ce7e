/* create/stream.h -- the stream of sensor frames of an iRobot Create 2.
 *
 * Asked once (command 148), the robot sends a frame every 15 ms:
 *
 *     13  N  ID DATA  ID DATA ...  SUM
 *
 * with the packets asked for, in that order. N counts the bytes between itself
 * and SUM. SUM makes the sum of the frame 0 modulo 256; for a Create 2 the
 * header 13 is part of it (libcreate), for a Create 1 it is not (the example in
 * its manual), so that is a setting. No I/O here, and nothing allocates. */
#ifndef FROB_CREATE_STREAM_H
#define FROB_CREATE_STREAM_H

#include "drivers/create/sensors.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
    FROB_CREATE_HEADER = 19,
    FROB_CREATE_MAX_IDS = 52, /* each single packet once */
    /* What fits in 15 ms at 115200 baud; and the ring below holds it. */
    FROB_CREATE_MAX_FRAME = 172
};

/* What was asked for, and what was received last.
 *
 * A frame is looked for backwards from each byte: it is a frame if header,
 * length, every id at its place and the sum are right. So bytes before it,
 * whatever they are, never hide it: each good frame is found the moment its
 * last byte is in. */
struct frob_create_stream {
    uint8_t ids[FROB_CREATE_MAX_IDS];
    uint8_t id_count;
    uint8_t frame_size;  /* with header, N and sum */
    bool header_in_sum;  /* true for a Create 2 */
    uint8_t window[256]; /* a ring of bytes received */
    uint8_t next;        /* where the next byte goes; wraps as the ring does */
    uint8_t sum;         /* of the last frame_size bytes, modulo 256 */
};

/* Prepares to receive frames of these packets. False if a packet is unknown,
 * there is none, or the frame would be over FROB_CREATE_MAX_FRAME. */
bool frob_create_stream_init(struct frob_create_stream *stream, const uint8_t *ids, size_t count,
                             bool header_in_sum);

/* Forgets the bytes received. */
void frob_create_stream_clear(struct frob_create_stream *stream);

/* Takes a byte. True when it completes a frame, whose packets are then in
 * `sensors`; fields of other packets, and all of them when there is no frame,
 * stay as they were. */
bool frob_create_stream_receive(struct frob_create_stream *stream, uint8_t byte,
                                struct frob_create_sensors *sensors);

#ifdef __cplusplus
}
#endif
#endif
