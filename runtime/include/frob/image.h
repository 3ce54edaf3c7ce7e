/* frob/image.h -- what a camera saw: pixels, when, and from where.
 *
 * A host (the simulator, a robot's camera, a replay) fills in such a struct and hands
 * the program its address for one instant; the program passes it on to the kernels of
 * <frob/vision.h>, or to C of the user's own. Nothing is copied on the way: the pixels
 * belong to the host, which keeps them unchanged until the instant is over.
 *
 * Image coordinates: x to the right, y down, in pixels; whole numbers are the middles
 * of pixels, so the picture covers -0.5 … width - 0.5. Metres, radians and
 * nanoseconds for all else. */
#ifndef FROB_IMAGE_H
#define FROB_IMAGE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* No picture is wider or higher: sums over one fit in 64 bits, a row's runs on the stack. */
#define FROB_IMAGE_SIDE 4096

enum frob_image_format {
    FROB_GREY8 = 0,  /* a byte a pixel, 0 black, 255 white */
    FROB_RGB8 = 1,   /* three bytes a pixel: red, green, blue */
    FROB_DEPTH_M = 2 /* a float a pixel: metres along the camera's axis, NaN where unknown */
};

/* How a camera projects, and where it sits.
 *
 * A point at X (right), Y (down), Z (ahead, along the axis) of the camera is seen at
 *   x = centre_x + focal_x a',  y = centre_y + focal_y b',   where a = X / Z, b = Y / Z
 * and, with r^2 = a^2 + b^2 (Brown's model, the names and order that OpenCV has),
 *   a' = a (1 + k1 r^2 + k2 r^4 + k3 r^6) + 2 p1 a b + p2 (r^2 + 2 a^2)
 *   b' = b (1 + k1 r^2 + k2 r^4 + k3 r^6) + p1 (r^2 + 2 b^2) + 2 p2 a b.
 * Without distortion k1 to p2 are 0.
 *
 * In the robot's frame (x ahead, y left, z up from the floor, origin between the
 * wheels) the camera sits at x_m, y_m, z_m. With all angles 0 it looks straight ahead,
 * its picture upright. yaw turns it to the left, then pitch down, then roll clockwise
 * as seen from behind it: the rotation is Rz(yaw) Ry(pitch) Rx(roll). */
struct frob_camera {
    double focal_x, focal_y;   /* pixels; above 0 */
    double centre_x, centre_y; /* where the axis meets the picture, pixels */
    double k1, k2, k3, p1, p2; /* distortion */
    double x_m, y_m, z_m;
    double yaw_rad, pitch_rad, roll_rad;
};

struct frob_image {
    int32_t width, height; /* pixels, 0 … FROB_IMAGE_SIDE */
    int32_t stride;        /* bytes from one row to the next: at least a row's own; of depths a
                            * multiple of sizeof(float) */
    enum frob_image_format format;
    const void *pixels;  /* the upper left one; of depths aligned as floats. NULL only if
                            * there is none */
    int64_t captured_ns; /* the middle of its exposure, on the clock of the program's time */
    uint32_t number;     /* of the frame since the camera started, from 0; those that never
                            * reached the program count too */
    struct frob_camera camera;
};

/* Bytes of a pixel; 0 of a format that there is not. */
static inline int32_t frob_image_pixel_size(enum frob_image_format format)
{
    switch (format) {
    case FROB_GREY8: return 1;
    case FROB_RGB8: return 3;
    case FROB_DEPTH_M: return (int32_t)sizeof(float);
    }
    return 0;
}

/* Whether what is said of the pixels fits together. Kernels take an image of which
 * it does not for one without pixels; hosts check what a camera or a file says. */
static inline bool frob_image_is_sound(const struct frob_image *image)
{
    const int32_t size = frob_image_pixel_size(image->format);

    if (size == 0 || image->width < 0 || image->width > FROB_IMAGE_SIDE || image->height < 0 ||
        image->height > FROB_IMAGE_SIDE || image->stride < image->width * size)
        return false;
    if (image->format == FROB_DEPTH_M &&
        (image->stride % size != 0 || (uintptr_t)image->pixels % sizeof(float) != 0))
        return false;
    return image->pixels != NULL || image->width == 0 || image->height == 0;
}

/* Row y, 0 … height - 1; of depths cast it to const float *. */
static inline const uint8_t *frob_image_row(const struct frob_image *image, int32_t y)
{
    return (const uint8_t *)image->pixels + (ptrdiff_t)y * image->stride;
}

#ifdef __cplusplus
}
#endif
#endif
