/* frob/lens.h -- the data of an image other than its pixels, as numbers for a program: the
 * projection of its camera (the record Lens of the library's module Vision), and a key. */
#ifndef FROB_LENS_H
#define FROB_LENS_H

#include <frob/image.h>

#ifdef __cplusplus
extern "C" {
#endif

#ifndef FROB_LENS_DEFINED
#define FROB_LENS_DEFINED

/* The members of struct frob_camera, and the size of the image; in pixels, metres and radians. */
struct frob_lens {
    double width, height;
    double focalX, focalY, centreX, centreY;
    double k1, k2, k3, p1, p2;
    double ahead, left, up;
    double yaw, pitch, roll;
};

#endif

void frob_image_lens(const struct frob_image *image, struct frob_lens *result);

/* Returns a key that distinguishes an image from others taken at about the same time. The key
 * depends on the image's number, capture time and size, and on the camera's projection and pose,
 * but not on the pixels. It is the same on every machine. */
int32_t frob_image_key(const struct frob_image *image);

#ifdef __cplusplus
}
#endif
#endif
