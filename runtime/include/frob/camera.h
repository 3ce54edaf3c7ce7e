/* frob/camera.h -- what cameras saw, as part of a program's input.
 *
 * The cameras that a program asks for are in its table (`console`, of the kind FROB_CAMERA),
 * under their labels: "camera", or "left" and "right". At each instant a host gives each of them
 * the newest frame that it has, once; or none. */
#ifndef FROB_CAMERA_H
#define FROB_CAMERA_H

#include <frob/image.h>
#include <frob/program.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How much of the label of something on the console is that of a camera: all of it, or for tags
 * (frob/tags.h) what stands before " tags"; 0 if it has no camera. */
size_t frob_camera_label(const struct frob_control *control);

/* The event of this instant: the frame, with its age at the time `now_ns`; NULL for none. The
 * image and its pixels stay until the instant is over. */
void frob_camera_give(const struct frob_control *camera, void *input,
                      const struct frob_image *image, int64_t now_ns);

/* A number of a frame that is no image: `age` or `number`, by the field's name; 0 without an image.
 * For all that comes with frames, as tags do (frob/tags.h). */
void frob_camera_give_number(const struct frob_field *field, void *input,
                             const struct frob_image *image, int64_t now_ns);

/* Puts a number where the value is, which is an Int or a Float of either precision. */
void frob_camera_set_number(void *input, const struct frob_value *value, double x);

/* Called for each image that is there in a value, and for the place of its address. */
typedef void frob_image_visitor(void *context, const struct frob_image **image);

/* Visits the images in the struct that the value describes. */
void frob_camera_images(const struct frob_value *value, void *base, frob_image_visitor *visit,
                        void *context);

#ifdef __cplusplus
}
#endif
#endif
