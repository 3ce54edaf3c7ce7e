/* decode.h -- the bytes of one frame to pixels. No I/O. */
#ifndef FROB_HOST_CAMERA_DECODE_H
#define FROB_HOST_CAMERA_DECODE_H

#include "source.h"

/* The size of a frame as the settings say of raw ones: 0 if they do not. */
size_t decode_raw_size(const struct camera_options *o);

/* A picture that tells its form itself: PGM or PPM of 8 bits, or JPEG. NULL, or why there is no
 * frame: cause and cure, about "a frame", in `message`. `is_grey`: colours are left out. */
const char *decode_picture(const uint8_t *bytes, size_t size, bool is_grey, struct captured *frame,
                           char message[256]);

/* PGM or PPM, in which the frame's own camera may be told (<frob/frame.h>). */
const char *decode_netpbm(const uint8_t *bytes, size_t size, struct captured *frame,
                          char message[256]);

/* By libjpeg-turbo, if this machine has it. */
const char *decode_jpeg(const uint8_t *bytes, size_t size, bool is_grey, struct captured *frame,
                        char message[256]);

/* Whether the frame has room for so many pixels; then its size is set. Why not. */
const char *decode_set_size(struct captured *frame, int64_t width, int64_t height,
                            enum frob_image_format format, char message[256]);

/* Brightness instead of colours, in place. */
void decode_to_grey(struct captured *frame);

#endif
