/* frob/lens.h -- how an image's camera sees, as numbers for a program: the record Lens of the
 * library's module Vision. */
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

#ifdef __cplusplus
}
#endif
#endif
