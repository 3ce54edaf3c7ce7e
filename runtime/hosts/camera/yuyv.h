/* yuyv.h -- frames as cameras give them that do not compress: YUV 4:2:2 packed, and grey. No I/O. */
#ifndef FROB_HOST_CAMERA_YUYV_H
#define FROB_HOST_CAMERA_YUYV_H

#include "buffers.h"

/* Fills in the pixels of a frame whose size and format are set: colours, or brightness alone.
 * `stride`: bytes from one row to the next. False if there are not as many bytes. */
bool yuyv_or_grey(const uint8_t *bytes, size_t size, size_t stride, bool is_yuyv,
                  struct captured *frame);

#endif
