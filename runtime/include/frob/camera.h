/* frob/camera.h -- camera frames as part of a program's input.
 *
 * In the program's table, `console` lists the cameras that the program uses. They have the kind
 * FROB_CAMERA, and a label such as "camera", or "left" and "right". At each instant a host passes
 * the newest frame of each camera, or none if there is no new frame. Each frame is passed once. */
#ifndef FROB_CAMERA_H
#define FROB_CAMERA_H

#include <frob/image.h>
#include <frob/program.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Returns the length of the camera's label within a control's label. For a camera, this is the
 * whole label; for tags (frob/tags.h), the part before " tags"; for other controls, 0. */
size_t frob_camera_label(const struct frob_control *control);

/* Sets the camera's event for this instant to the frame and its age at the time `now_ns`. Sets no
 * event if `image` is NULL. The image and its pixels must stay valid until the end of the
 * instant. */
void frob_camera_give(const struct frob_control *camera, void *input,
                      const struct frob_image *image, int64_t now_ns);

/* Sets an input field to the frame's age at the time `now_ns` if the field is called `age`, and
 * otherwise to the frame's number. Sets it to 0 if `image` is NULL. Also used for other data that
 * comes with frames, such as tags (frob/tags.h). */
void frob_camera_give_number(const struct frob_field *field, void *input,
                             const struct frob_image *image, int64_t now_ns);

/* Stores a number in the part of the input that `value` describes: an Int, or a Float of either
 * precision. */
void frob_camera_set_number(void *input, const struct frob_value *value, double x);

/* Called for each image within a value, with the address of its pointer. */
typedef void frob_image_visitor(void *context, const struct frob_image **image);

/* Visits the images in the struct that `value` describes. */
void frob_camera_images(const struct frob_value *value, void *base, frob_image_visitor *visit,
                        void *context);

#ifdef __cplusplus
}
#endif
#endif
