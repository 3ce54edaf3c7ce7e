/* decode.h -- decodes the bytes of one frame to pixels. No I/O. */
#ifndef FROB_HOST_CAMERA_DECODE_H
#define FROB_HOST_CAMERA_DECODE_H

#include "source.h"

/* Returns the size of a raw frame according to the settings; 0 if they do not specify it. */
size_t decode_raw_size(const struct camera_options *o);

/* Decodes an image in a self-describing format: 8-bit PGM or PPM, or JPEG. Returns NULL on success.
 * On failure, returns `message`, which explains the cause and the fix in a sentence about "a
 * frame". If `is_grey`, decodes brightness only. */
const char *decode_picture(const uint8_t *bytes, size_t size, bool is_grey, struct captured *frame,
                           char message[256]);

/* Decodes PGM or PPM, which may also contain the camera's projection and pose (<frob/frame.h>). */
const char *decode_netpbm(const uint8_t *bytes, size_t size, struct captured *frame,
                          char message[256]);

/* Decodes JPEG with libjpeg-turbo, if it is installed. */
const char *decode_jpeg(const uint8_t *bytes, size_t size, bool is_grey, struct captured *frame,
                        char message[256]);

/* Sets the frame's size if the frame has room for that many pixels. Returns NULL on success, or
 * an error message. */
const char *decode_set_size(struct captured *frame, int64_t width, int64_t height,
                            enum frob_image_format format, char message[256]);

/* Converts the frame's colours to brightness, in place. */
void decode_to_grey(struct captured *frame);

#endif
