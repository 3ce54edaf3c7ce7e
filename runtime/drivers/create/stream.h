/* create/stream.h -- the stream of sensor frames of an iRobot Create 2.
 *
 * After one request (command 148) the robot sends a frame every 15 ms:
 *
 *     13  N  ID DATA  ID DATA ...  SUM
 *
 * with the requested packets in the requested order. N is the number of bytes between N and SUM.
 * SUM is chosen so that the sum of the frame is 0 modulo 256. For a Create 2, the sum includes the
 * header 13 (according to libcreate). For a Create 1, it does not (according to the example in its
 * manual). Therefore the driver has a setting for this. This module does no I/O and does not
 * allocate. */
#ifndef FROB_CREATE_STREAM_H
#define FROB_CREATE_STREAM_H

#include "drivers/create/sensors.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
    FROB_CREATE_HEADER = 19,
    FROB_CREATE_MAX_IDS = 52, /* a stream of every single packet */
    /* A frame of this size can be sent in 15 ms at 115200 baud, and fits in the ring below. */
    FROB_CREATE_MAX_FRAME = 172
};

/* The requested packets, and the bytes received last.
 *
 * The receiver searches for a frame backwards from each byte. Bytes are a frame if the header, the
 * length, every id and the sum are correct. Therefore bytes before a frame never hide it, and every
 * valid frame is found as soon as its last byte arrives. */
struct frob_create_stream {
    uint8_t ids[FROB_CREATE_MAX_IDS];
    uint8_t id_count;
    uint8_t frame_size;  /* including header, N and SUM */
    bool header_in_sum;  /* true for a Create 2 */
    uint8_t window[256]; /* ring buffer of received bytes */
    uint8_t next;        /* index of the next byte, which wraps around at the end of the ring */
    uint8_t sum;         /* sum of the last frame_size bytes, modulo 256 */
};

/* Prepares to receive frames of these packets. Returns false if a packet is unknown, if there are
 * no packets, or if the frame would be longer than FROB_CREATE_MAX_FRAME. */
bool frob_create_stream_init(struct frob_create_stream *stream, const uint8_t *ids, size_t count,
                             bool header_in_sum);

/* Discards the bytes received so far. */
void frob_create_stream_clear(struct frob_create_stream *stream);

/* Handles a received byte. If it completes a frame, stores the frame's packets in `sensors` and
 * returns true. The fields of other packets stay unchanged, and so do all fields if there is no
 * frame. */
bool frob_create_stream_receive(struct frob_create_stream *stream, uint8_t byte,
                                struct frob_create_sensors *sensors);

#ifdef __cplusplus
}
#endif
#endif
