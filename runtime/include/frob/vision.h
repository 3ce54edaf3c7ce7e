/* frob/vision.h -- the image-processing kernels of runtime/vision, for the library's module Vision,
 * which imports them, and for the user's own C code.
 *
 * Each kernel passes over the pixels a small number of times; its time is bounded by the size of
 * the image or of the request. No kernel allocates or keeps state. Kernels need at most 30 kB of
 * stack, except frob_match_patch (100 kB), frob_find_corner (140 kB), frob_find_blobs (250 kB) and
 * frob_stereo_depths (350 kB). The same image yields the same bits on every machine: kernels
 * compute with integers where they suffice, and otherwise with IEEE doubles in a fixed order.
 *
 * Any argument is safe, including NaN. An image that is not sound (frob_image_is_sound) is treated
 * as having no pixels, and a region may extend beyond the image. If nothing is found, the result
 * says so. Functions that also exist in OpenMV have the same names as there.
 *
 * Coordinates are those of frob/image.h. Angles are in radians from the x axis towards the y axis,
 * which is clockwise in the displayed image. Brightness is grey, 0 … 255; for a colour it is (77
 * red + 150 green + 29 blue) / 256, rounded. */
#ifndef FROB_VISION_H
#define FROB_VISION_H

#include <frob/image.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Structs that represent Frob's records, with the same field names. Generated headers define the
 * same structs. */

/* The pixels whose centres are within [x, x + width) and [y, y + height). */
#ifndef FROB_REGION_DEFINED
#define FROB_REGION_DEFINED
struct frob_region {
    double x, y, width, height;
};
#endif

/* A range of colours by hue, saturation and value; both ends are included. Hue is an angle on the
 * HSV colour hexagon: red is 0, green 120 degrees, blue 240. It increases from hueFrom to hueTo, so
 * the range from 350 to 10 degrees contains 0, which is red. A range of a full turn or more
 * contains every hue, and grey matches every hue. Saturation and value are 0 … 1. Hue is rounded to
 * half a degree, saturation to 1/128. */
#ifndef FROB_COLOUR_RANGE_DEFINED
#define FROB_COLOUR_RANGE_DEFINED
struct frob_colour_range {
    double hueFrom, hueTo, saturationFrom, saturationTo, valueFrom, valueTo;
};
#endif

/* A set of pixels: their number, centroid and bounding box, and the ellipse with the same second
 * moments, given by the lengths of both axes and the direction of the major axis, in (-pi/2, pi/2].
 * All members are 0 if there are no pixels. */
#ifndef FROB_BLOB_DEFINED
#define FROB_BLOB_DEFINED
struct frob_blob {
    int32_t pixels;
    double cx, cy;
    struct frob_region box;
    double major, minor, rotation;
};
#endif

/* The largest blobs, ordered by decreasing size; if two have the same size, the upper one is first.
 * Unused elements are 0. */
#ifndef FROB_BLOBS_DEFINED
#define FROB_BLOBS_DEFINED
struct frob_blobs {
    int32_t count;
    struct frob_blob largest[8];
};
#endif

/* Finds all pixels of the region that are in the colour range, as one blob. In a grey image, all
 * colours have saturation 0; a depth image has no colours. */
void frob_find_blob(const struct frob_image *image, const struct frob_region *roi,
                    const struct frob_colour_range *colours, struct frob_blob *result);

/* Finds the largest connected sets of pixels in the colour range; pixels are connected by sides or
 * corners. Sets that end above the current row are finished immediately, so memory is bounded by
 * the width. */
void frob_find_blobs(const struct frob_image *image, const struct frob_region *roi,
                     const struct frob_colour_range *colours, struct frob_blobs *result);

/* ---- Brightness and depth of a region */

/* Statistics of brightness, or, for a depth image, of the known depths in metres (finite and above
 * 0). Half of the pixels are at most the median, a quarter at most lq, three quarters at most uq;
 * each of the three is the value of a pixel. All members are 0 if there are no pixels. */
#ifndef FROB_STATISTICS_DEFINED
#define FROB_STATISTICS_DEFINED
struct frob_statistics {
    int32_t pixels;
    double mean, stdev, min, lq, median, uq, max;
};
#endif

void frob_get_statistics(const struct frob_image *image, const struct frob_region *roi,
                         struct frob_statistics *result);

/* Counts the pixels with each brightness. All counts are 0 for a depth image. */
void frob_get_histogram(const struct frob_image *image, const struct frob_region *roi,
                        int32_t result[256]);

/* ---- Edges and corners */

/* A position in an image, a direction, or another pair of numbers. */
#ifndef FROB_VEC2_DEFINED
#define FROB_VEC2_DEFINED
struct frob_vec2 {
    double x, y;
};
#endif

/* The line along which to search for an edge. It has the given `length` (at most 128) and
 * direction, and its centre is (x, y). Brightness is averaged over `width` (1 … 32) across the
 * line. */
#ifndef FROB_SEGMENT_DEFINED
#define FROB_SEGMENT_DEFINED
struct frob_segment {
    double x, y, angle, length, width;
};
#endif

/* An edge: its signed distance from the centre of the segment, and the change in brightness per
 * pixel there. Both are 0 if there is no edge. */
#ifndef FROB_EDGE_DEFINED
#define FROB_EDGE_DEFINED
struct frob_edge {
    double offset, gradient;
};
#endif

/* The strongest edges along a segment. Brightness increases at the rising edge and decreases at the
 * falling edge, whose gradient is negative. Parts of the segment outside the image have no
 * edges. */
#ifndef FROB_EDGES_DEFINED
#define FROB_EDGES_DEFINED
struct frob_edges {
    struct frob_edge rising, falling;
};
#endif

void frob_find_edges(const struct frob_image *image, const struct frob_segment *segment,
                     struct frob_edges *result);

/* Shi and Tomasi's corner score: the smaller eigenvalue of the mean of g g^T, where g is the
 * gradient at each of the 5 by 5 pixels around the position; in (brightness per pixel)^2. A
 * straight edge scores 0. */
#ifndef FROB_CORNER_DEFINED
#define FROB_CORNER_DEFINED
struct frob_corner {
    double x, y, score;
};
#endif

/* Finds the position with the best score in a region, with subpixel precision; the score is 0 if
 * there is none. */
void frob_find_corner(const struct frob_image *image, const struct frob_region *roi,
                      struct frob_corner *result);

/* ---- Patches: templates of 32 by 32 samples */

enum { FROB_PATCH_SIDE = 32, FROB_PATCH_SIZE = FROB_PATCH_SIDE * FROB_PATCH_SIDE };

/* Position of a patch in an image: its centre, its rotation, and the distance between neighbouring
 * samples in pixels. Sample i of row j is at scale (i - 15.5, j - 15.5), rotated, relative to the
 * centre. If samples are more than a pixel apart, each is the mean of up to 4 by 4 pixels. */
#ifndef FROB_PLACEMENT_DEFINED
#define FROB_PLACEMENT_DEFINED
struct frob_placement {
    double x, y, angle, scale;
};
#endif

/* Reads the brightness of each sample. Samples outside the image have the brightness at its border.
 * All samples are 0 if the image has no pixels or the placement is invalid. */
void frob_get_patch(const struct frob_image *image, const struct frob_placement *place,
                    double result[FROB_PATCH_SIZE]);

/* The best placement of a patch, and the residual there: the square root of 1 - r^2, where r is the
 * correlation between the brightness of the patch and that of the image. A residual of 0 means a
 * perfect match, and 1 no similarity at all; brightness offset and contrast have no effect. The
 * residual is also 1 if more than a quarter of the patch is outside the image. */
#ifndef FROB_MATCH_DEFINED
#define FROB_MATCH_DEFINED
struct frob_match {
    struct frob_placement place;
    double residual;
};
#endif

/* Parameters of a search for a patch. The search starts at the placement `from` and the pyramid
 * level `level`: 0 is full resolution; 1 and 2 use means of 2 by 2 and 4 by 4 samples, which
 * increase the reach by the same factor. `iterations` is the number of iterations at each level, at
 * most 30. `freedom` is the number of degrees of freedom: 2 for the position, 3 to add the angle, 4
 * to add the scale as well, between half and twice its initial value. */
#ifndef FROB_SEARCH_DEFINED
#define FROB_SEARCH_DEFINED
struct frob_search {
    struct frob_placement from;
    int32_t level, iterations, freedom;
};
#endif

/* Finds the best match near the start, by least squares (sum of squared differences, SSD). */
void frob_match_patch(const struct frob_image *image, const double patch[FROB_PATCH_SIZE],
                      const struct frob_search *search, struct frob_match *result);

/* Finds where in a region the patch matches best, at the angle and scale of `like`, on a grid with
 * a spacing of a few samples. Use the result as the starting placement for frob_match_patch at
 * level 2. The region is searched at a resolution of at most 160 by 120 cells. */
void frob_find_template(const struct frob_image *image, const struct frob_region *roi,
                        const double patch[FROB_PATCH_SIZE], const struct frob_placement *like,
                        struct frob_match *result);

/* ---- Distortion */

/* frob_undistort_point returns where a camera without distortion would see what this camera sees at
 * `point`; frob_distort_point is the inverse. If the distortion cannot be inverted at a point,
 * undistort returns `point` itself. */
void frob_undistort_point(const struct frob_image *image, const struct frob_vec2 *point,
                          struct frob_vec2 *result);
void frob_distort_point(const struct frob_image *image, const struct frob_vec2 *point,
                        struct frob_vec2 *result);

/* ---- Stereo
 *
 * Both images of a pair have the same size, come from cameras that are side by side, and are
 * undistorted and rectified: a point in a row of the left image is in the same row of the right
 * image, shifted to the left by its disparity. Nearer points have larger disparities. */

/* Parameters of stereo matching: the region of the left image; the number of disparities to try,
 * from 0 up (16 … 256, a multiple of 16); and the side of the compared windows (5 … 21, odd). Other
 * values are rounded to the nearest valid one. */
#ifndef FROB_STEREO_DEFINED
#define FROB_STEREO_DEFINED
struct frob_stereo {
    struct frob_region roi;
    int32_t disparities, window;
};
#endif

/* Returns the number of bytes of memory that frob_match_stereo needs for a region of this width. */
size_t frob_stereo_room(int32_t width, const struct frob_stereo *how);

/* Computes the disparity of each pixel of the region, in units of 1/16 pixel. It is -1 if unknown:
 * the texture is too weak, two disparities match equally well, or the corresponding pixel in the
 * right image, if it is within the region, matches best at a different disparity. `stride` is the
 * number of elements from one row of the result to the next. Returns false and writes nothing if
 * the images are not a pair or `room` is too small. */
bool frob_match_stereo(const struct frob_image *left, const struct frob_image *right,
                       const struct frob_stereo *how, uint16_t *room, size_t room_size,
                       int16_t *result, int32_t stride);

/* Depths in a region, in metres along the optical axis. For each of 16 columns: the smallest depth
 * such that at least 5 % of its pixels, and at least eight, are at this depth or nearer; infinite
 * for disparity 0. For the whole region: the nearest depth, by the same rule, and the median. NaN
 * if fewer pixels than that are known, or if the cameras are at the same position. `known` is the
 * fraction of pixels whose disparity is known. */
#ifndef FROB_DEPTHS_DEFINED
#define FROB_DEPTHS_DEFINED
struct frob_depths {
    double known, nearest, median;
    double columns[16];
};
#endif

/* Limits the region to its middle 640 columns, and the disparities to 64; needs 350 kB of stack. */
void frob_stereo_depths(const struct frob_image *left, const struct frob_image *right,
                        const struct frob_stereo *how, struct frob_depths *result);

/* ---- Tags */

/* An AprilTag found in an image: its number, its centre, and the corners of its black frame,
 * counter-clockwise in the displayed image, starting at the lower left corner of an upright tag.
 * `margin` is the difference in brightness between its black and white cells, 0 … 255. */
#ifndef FROB_TAG_DEFINED
#define FROB_TAG_DEFINED
struct frob_tag {
    int32_t id;
    struct frob_vec2 middle;
    struct frob_vec2 corners[4];
    double margin;
};
#endif

#ifndef FROB_VEC3_DEFINED
#define FROB_VEC3_DEFINED
struct frob_vec3 {
    double x, y, z;
};
#endif

/* Pose of a tag relative to the camera (x to the right, y down, z ahead): its centre, in metres;
 * the direction of its face, which points towards the camera; the root mean square distance, in
 * pixels, between the corners that were found and those that this pose predicts; and the ambiguity
 * between this pose and the other pose that looks nearly the same. The ambiguity is the residual of
 * this pose divided by the residual of the other: 0 is certain, 1 is a guess. */
#ifndef FROB_TAG_PLACE_DEFINED
#define FROB_TAG_PLACE_DEFINED
struct frob_tag_place {
    struct frob_vec3 middle, facing;
    double residual, ambiguity;
};
#endif

struct frob_lens;

/* Estimates the pose of a tag whose black frame is `size` wide and high: removes the lens's
 * distortion from the corners, and minimizes the sum of their squared distances from the predicted
 * corners. All results are NaN if no such tag can exist: the corners are collinear or in the wrong
 * order, or the size is not positive. */
void frob_find_tag_place(const struct frob_lens *lens, double size, const struct frob_tag *tag,
                         struct frob_tag_place *result);

#ifdef __cplusplus
}
#endif
#endif
