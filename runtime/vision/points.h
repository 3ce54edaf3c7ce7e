/* points.h -- applies and removes lens distortion, for kernels that have no image. */
#ifndef FROB_VISION_POINTS_H
#define FROB_VISION_POINTS_H

#include <frob/vision.h>

/* The same as frob_undistort_point (frob/vision.h), but takes a camera instead of an image, and
 * ignores the camera's pose. */
void frob_undistort(const struct frob_camera *camera, const struct frob_vec2 *point,
                    struct frob_vec2 *result);

#endif
