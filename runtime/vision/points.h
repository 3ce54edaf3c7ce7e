/* points.h -- distortion of a camera's lens, for kernels that have no image. */
#ifndef FROB_VISION_POINTS_H
#define FROB_VISION_POINTS_H

#include <frob/vision.h>

/* As frob_undistort_point (frob/vision.h), by the camera alone: where it sits does not matter. */
void frob_undistort(const struct frob_camera *camera, const struct frob_vec2 *point,
                    struct frob_vec2 *result);

#endif
