/* frob/lens.h -- what an image says besides its pixels, as numbers for a program: how its camera
 * sees, the record Lens of the library's module Vision, and a key. */
#ifndef FROB_LENS_H
#define FROB_LENS_H

#include <frob/image.h>

#ifdef __cplusplus
extern "C" {
#endif

#ifndef FROB_LENS_DEFINED
#define FROB_LENS_DEFINED

/* As in struct frob_camera; pixels, metres, radians. */
struct frob_lens {
    double width, height;
    double focalX, focalY, centreX, centreY;
    double k1, k2, k3, p1, p2;
    double ahead, left, up;
    double yaw, pitch, roll;
};

#endif

void frob_image_lens(const struct frob_image *image, struct frob_lens *result);

/* Tells the images that are there at about the same time from each other: those of one camera by
 * their number and when they were taken, those of several by how these see and where they sit. It
 * looks at no pixel, and is the same on every machine. */
int32_t frob_image_key(const struct frob_image *image);

#ifdef __cplusplus
}
#endif
#endif
