/* Checks that the layouts in runtime/hosts/common/apriltag.h match the library's own headers.
 * This file only needs to compile. */
#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>

#include "apriltag.h"

#define SAME(own, own_part, its, its_part)                                                  \
    _Static_assert(offsetof(struct own, own_part) == offsetof(its, its_part) &&             \
                       sizeof(((struct own *)0)->own_part) == sizeof(((its *)0)->its_part), \
                   #own "." #own_part)

SAME(apriltag_image, width, image_u8_t, width);
SAME(apriltag_image, height, image_u8_t, height);
SAME(apriltag_image, stride, image_u8_t, stride);
SAME(apriltag_image, pixels, image_u8_t, buf);
SAME(apriltag_array, element_size, zarray_t, el_sz);
SAME(apriltag_array, count, zarray_t, size);
SAME(apriltag_array, elements, zarray_t, data);
SAME(apriltag_settings, threads, apriltag_detector_t, nthreads);
SAME(apriltag_settings, decimate, apriltag_detector_t, quad_decimate);
SAME(apriltag_settings, quads.least_contrast, apriltag_detector_t, qtp.min_white_black_diff);
SAME(apriltag_found, id, apriltag_detection_t, id);
SAME(apriltag_found, wrong_bits, apriltag_detection_t, hamming);
SAME(apriltag_found, margin, apriltag_detection_t, decision_margin);
SAME(apriltag_found, middle, apriltag_detection_t, c);
SAME(apriltag_found, corners, apriltag_detection_t, p);

_Static_assert(sizeof(struct apriltag_image) == sizeof(image_u8_t), "images");

/* The functions that a host calls have these types. */
static apriltag_family_t *(*const make_family)(void) = tag36h11_create;
static void (*const add)(apriltag_detector_t *, apriltag_family_t *,
                         int) = apriltag_detector_add_family_bits;
static zarray_t *(*const detect)(apriltag_detector_t *, image_u8_t *) = apriltag_detector_detect;
static void (*const destroy)(zarray_t *) = apriltag_detections_destroy;

int main(void)
{
    return make_family == NULL || add == NULL || detect == NULL || destroy == NULL;
}
