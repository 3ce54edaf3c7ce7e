/* apriltag.h -- as much of the AprilTag library, version 3, as a host needs.
 *
 * Declared here, so that hosts are built where its headers are not. The layout is what programs
 * have been compiled against since 3.1, and the library's name (libapriltag.so.3) stands for it;
 * tests/generated/vision/apriltag_test.c compares with the headers of the one that is there. */
#ifndef FROB_HOST_APRILTAG_H
#define FROB_HOST_APRILTAG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define APRILTAG_LIBRARY "libapriltag.so.3"

/* image_u8_t */
struct apriltag_image {
    int32_t width, height, stride;
    uint8_t *pixels;
};

/* zarray_t */
struct apriltag_array {
    size_t element_size;
    int count, capacity;
    char *elements;
};

/* The beginning of apriltag_detector_t, which the library makes. */
struct apriltag_settings {
    int threads;
    float decimate; /* looks at a picture that is smaller by this factor first */
    float blur;
    bool refines_edges;
    double sharpening;
    bool debugs;
    struct { /* apriltag_quad_thresh_params */
        int least_cluster, most_corners;
        float angle, cosine, most_error;
        int least_contrast; /* between the lightest and the darkest pixel of a few tiles */
        int deglitch;
    } quads;
};

/* apriltag_detection_t. In its coordinates the middle of the upper left pixel is at
 * (0.5, 0.5). */
struct apriltag_found {
    void *family;
    int id, wrong_bits;
    float margin;
    void *homography;
    double middle[2];
    double corners[4][2];
};

#endif
