/* apriltag.h -- the part of the AprilTag library, version 3, that a host needs.
 *
 * It is declared here so that hosts can be built without the library's headers. The layout has not
 * changed since 3.1, and the version in the library's name (libapriltag.so.3) guarantees it.
 * tests/generated/vision/apriltag_test.c compares these declarations with the headers of the
 * installed library. */
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

/* The first members of apriltag_detector_t, which the library allocates. */
struct apriltag_settings {
    int threads;
    float decimate; /* factor by which the image is reduced for the first search */
    float blur;
    bool refines_edges;
    double sharpening;
    bool debugs;
    struct { /* apriltag_quad_thresh_params */
        int least_cluster, most_corners;
        float angle, cosine, most_error;
        int least_contrast; /* minimum contrast within a group of adjacent tiles */
        int deglitch;
    } quads;
};

/* apriltag_detection_t. In its coordinates the centre of the upper left pixel is (0.5, 0.5). */
struct apriltag_found {
    void *family;
    int id, wrong_bits;
    float margin;
    void *homography;
    double middle[2];
    double corners[4][2];
};

#endif
