/* points.h -- applies and removes lens distortion, for kernels that have no image. */
#ifndef FROB_VISION_POINTS_H
#define FROB_VISION_POINTS_H

#include <frob/vision.h>

/* The same as frob_undistort_point (frob/vision.h), but takes only the camera, whose pose is not
 * used. */
void frob_undistort(const struct frob_camera *camera, const struct frob_vec2 *point,
                    struct frob_vec2 *result);

#endif
