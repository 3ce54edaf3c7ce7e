/* yuyv.h -- converts uncompressed camera frames: packed YUV 4:2:2, and grey. No I/O. */
#ifndef FROB_HOST_CAMERA_YUYV_H
#define FROB_HOST_CAMERA_YUYV_H

#include "buffers.h"

/* Converts the pixels to the frame's format, which is RGB or grey. The caller must set the frame's
 * size and format. `stride` is the number of bytes from one row to the next. Returns false if there
 * are not enough bytes. */
bool yuyv_or_grey(const uint8_t *bytes, size_t size, size_t stride, bool is_yuyv,
                  struct captured *frame);

#endif
