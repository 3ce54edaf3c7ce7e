/* frob/image.h -- a camera image: its pixels, and the time and place at which it was taken.
 *
 * A host (the simulator, a robot's camera, a replay) fills in such a struct and passes its address
 * to the program for one instant. The program passes it on to the kernels of <frob/vision.h>, or to
 * the user's own C functions. Pixels are never copied: they belong to the host, which keeps them
 * unchanged until the end of the instant.
 *
 * Image coordinates are in pixels: x to the right, y down. Pixel centres have integer coordinates,
 * so the image covers -0.5 … width - 0.5. Everything else is in metres, radians and nanoseconds. */
#ifndef FROB_IMAGE_H
#define FROB_IMAGE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Maximum width and height. With this limit, sums over an image fit in 64 bits, and the runs of a
 * row fit on the stack. */
#define FROB_IMAGE_SIDE 4096

enum frob_image_format {
    FROB_GREY8 = 0,  /* one byte per pixel: 0 is black, 255 white */
    FROB_RGB8 = 1,   /* three bytes per pixel: red, green, blue */
    FROB_DEPTH_M = 2 /* a float per pixel: metres along the optical axis, NaN if unknown */
};

/* Projection and pose of a camera.
 *
 * A point at X (right), Y (down), Z (ahead, along the optical axis) in the camera's frame appears
 * at
 *   x = centre_x + focal_x a',  y = centre_y + focal_y b',   where a = X / Z, b = Y / Z
 * and, with r^2 = a^2 + b^2 (Brown's distortion model, with OpenCV's names and order),
 *   a' = a (1 + k1 r^2 + k2 r^4 + k3 r^6) + 2 p1 a b + p2 (r^2 + 2 a^2)
 *   b' = b (1 + k1 r^2 + k2 r^4 + k3 r^6) + p1 (r^2 + 2 b^2) + 2 p2 a b.
 * Without distortion k1 to p2 are 0.
 *
 * The camera is at x_m, y_m, z_m in the robot's frame (x ahead, y left, z up from the floor, origin
 * between the wheels). If all angles are 0, it looks straight ahead and its image is upright. yaw
 * turns it to the left, then pitch turns it down, then roll turns it clockwise as seen from behind:
 * the rotation is Rz(yaw) Ry(pitch) Rx(roll). */
struct frob_camera {
    double focal_x, focal_y;   /* pixels, greater than 0 */
    double centre_x, centre_y; /* principal point, pixels */
    double k1, k2, k3, p1, p2; /* distortion */
    double x_m, y_m, z_m;
    double yaw_rad, pitch_rad, roll_rad;
};

struct frob_image {
    int32_t width, height; /* pixels, 0 … FROB_IMAGE_SIDE */
    /* Bytes from one row to the next: at least the size of a row and, for depths, a multiple of
     * sizeof(float). */
    int32_t stride;
    enum frob_image_format format;
    /* The upper left pixel. Depths are aligned like floats. NULL only if there are no pixels. */
    const void *pixels;
    /* The middle of the exposure, in the program's time. */
    int64_t captured_ns;
    /* Frame number since the camera started, from 0. Frames that did not reach the program also
     * count. */
    uint32_t number;
    struct frob_camera camera;
};

/* Returns the bytes per pixel, or 0 if the format is invalid. */
static inline int32_t frob_image_pixel_size(enum frob_image_format format)
{
    switch (format) {
    case FROB_GREY8: return 1;
    case FROB_RGB8: return 3;
    case FROB_DEPTH_M: return (int32_t)sizeof(float);
    }
    return 0;
}

/* Returns whether the image's members are consistent. Kernels treat an inconsistent image as an
 * image without pixels. Hosts check the data of cameras and files with this function. */
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

/* Returns row y, 0 … height - 1. If the pixels are depths, cast the result to const float *. */
static inline const uint8_t *frob_image_row(const struct frob_image *image, int32_t y)
{
    return (const uint8_t *)image->pixels + (ptrdiff_t)y * image->stride;
}

#ifdef __cplusplus
}
#endif
#endif
