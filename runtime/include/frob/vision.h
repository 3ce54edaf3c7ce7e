/* frob/vision.h -- what can be found in an image: the kernels of runtime/vision, as the
 * library's module Vision imports them, and for C of the user's own.
 *
 * Each looks at the pixels once or a few times, in time bounded by the image's size, or by
 * that of what is asked for. Nothing allocates, nothing is kept; the stack is at most
 * 30 kB, of frob_match_patch 100 kB, frob_find_corner 140 kB, frob_find_blobs 250 kB. The same
 * image gives the same bits on every machine: whole numbers where they do, and IEEE doubles,
 * in an order that is written down, elsewhere.
 *
 * Any argument is safe, NaN too. An image that is not sound (frob_image_is_sound) has no
 * pixels, a region may reach out of it, and where there is nothing to find the result says
 * so. Names are those of OpenMV where it has the thing.
 *
 * Coordinates are those of frob/image.h; angles in radians from the x axis towards the y
 * axis, so clockwise as one looks at the picture. Brightness is grey, 0 … 255; of colours
 * it is (77 red + 150 green + 29 blue) / 256, rounded. */
#ifndef FROB_VISION_H
#define FROB_VISION_H

#include <frob/image.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The structs of Frob's records, with their fields' names; generated headers have the same. */

/* The pixels whose middles are at x … x + width, without the latter, and likewise y. */
#ifndef FROB_REGION_DEFINED
#define FROB_REGION_DEFINED
struct frob_region {
    double x, y, width, height;
};
#endif

/* Colours by hue, saturation and value; both ends are inside. Hue is an angle, red 0, green
 * 120 degrees, blue 240, as by the colours' hexagon; it goes upwards from hueFrom to hueTo, so
 * from 350 to 10 degrees is red; a turn or more is every hue, and grey has every hue.
 * Saturation and value are 0 … 1. Hue is rounded to half a degree, saturation to 1/128. */
#ifndef FROB_COLOUR_RANGE_DEFINED
#define FROB_COLOUR_RANGE_DEFINED
struct frob_colour_range {
    double hueFrom, hueTo, saturationFrom, saturationTo, valueFrom, valueTo;
};
#endif

/* A set of pixels: how many, their mean place, the smallest region around them, and of the
 * ellipse with the same second moments the lengths of both axes and the direction of the
 * major one, above -pi/2 … pi/2. All 0 if there is no pixel. */
#ifndef FROB_BLOB_DEFINED
#define FROB_BLOB_DEFINED
struct frob_blob {
    int32_t pixels;
    double cx, cy;
    struct frob_region box;
    double major, minor, rotation;
};
#endif

/* As many of the largest as were found, largest first, of equal ones the upper one; the rest
 * is 0. */
#ifndef FROB_BLOBS_DEFINED
#define FROB_BLOBS_DEFINED
struct frob_blobs {
    int32_t count;
    struct frob_blob largest[8];
};
#endif

/* All pixels of the region that have such a colour, as one blob. A grey image has colours
 * without saturation, one of depths none. */
void frob_find_blob(const struct frob_image *image, const struct frob_region *roi,
                    const struct frob_colour_range *colours, struct frob_blob *result);

/* The largest sets of such pixels that hang together, by sides or corners. Sets that end
 * above the row that is looked at are done with, so memory is bounded by the width. */
void frob_find_blobs(const struct frob_image *image, const struct frob_region *roi,
                     const struct frob_colour_range *colours, struct frob_blobs *result);

/* {1 Brightness and depth of a region} */

/* Of brightness, or of an image of depths of the metres that are known: finite, above 0. Half
 * of the pixels are at most the median, a quarter at most lq, three at most uq, each of them
 * the value of a pixel. All 0 if there is none. */
#ifndef FROB_STATISTICS_DEFINED
#define FROB_STATISTICS_DEFINED
struct frob_statistics {
    int32_t pixels;
    double mean, stdev, min, lq, median, uq, max;
};
#endif

void frob_get_statistics(const struct frob_image *image, const struct frob_region *roi,
                         struct frob_statistics *result);

/* How many pixels have each brightness; of depths, none. */
void frob_get_histogram(const struct frob_image *image, const struct frob_region *roi,
                        int32_t result[256]);

/* {1 Edges, corners} */

/* A place in an image, and a direction or other pair of numbers. */
#ifndef FROB_VEC2_DEFINED
#define FROB_VEC2_DEFINED
struct frob_vec2 {
    double x, y;
};
#endif

/* Where to look for an edge: along a line through (x, y), half of `length` (at most 128) to
 * either side, in this direction; what is seen is the mean over `width` (1 … 32) across it. */
#ifndef FROB_SEGMENT_DEFINED
#define FROB_SEGMENT_DEFINED
struct frob_segment {
    double x, y, angle, length, width;
};
#endif

/* How far from the middle of the segment, and the change of brightness for each pixel there:
 * both 0 if there is none. */
#ifndef FROB_EDGE_DEFINED
#define FROB_EDGE_DEFINED
struct frob_edge {
    double offset, gradient;
};
#endif

/* The strongest edges along a segment: where it gets brighter, and where it gets darker (whose
 * gradient is below 0). Parts of the segment that are outside the image have none. */
#ifndef FROB_EDGES_DEFINED
#define FROB_EDGES_DEFINED
struct frob_edges {
    struct frob_edge rising, falling;
};
#endif

void frob_find_edges(const struct frob_image *image, const struct frob_segment *segment,
                     struct frob_edges *result);

/* Shi and Tomasi's score of a place: the smaller eigenvalue of the mean of g g^T, of the
 * gradients g in the 5 by 5 pixels around it, in (brightness per pixel)^2. An edge has 0. */
#ifndef FROB_CORNER_DEFINED
#define FROB_CORNER_DEFINED
struct frob_corner {
    double x, y, score;
};
#endif

/* The place with the best score in a region, between pixels; the score is 0 if there is none. */
void frob_find_corner(const struct frob_image *image, const struct frob_region *roi,
                      struct frob_corner *result);

/* {1 Patches: templates of 32 by 32 samples} */

enum { FROB_PATCH_SIDE = 32, FROB_PATCH_SIZE = FROB_PATCH_SIDE * FROB_PATCH_SIDE };

/* Where a patch lies: the place of its middle, how it is turned, and the pixels from one sample
 * to the next. Row by row, sample i of row j is at scale (i - 15.5, j - 15.5), turned, from
 * there. Where samples are more than a pixel apart each is the mean of up to 4 by 4. */
#ifndef FROB_PLACEMENT_DEFINED
#define FROB_PLACEMENT_DEFINED
struct frob_placement {
    double x, y, angle, scale;
};
#endif

/* The brightness of each sample; beyond the border as at it, and 0 if there are no pixels or
 * the place is none. */
void frob_get_patch(const struct frob_image *image, const struct frob_placement *place,
                    double result[FROB_PATCH_SIZE]);

/* Where a patch was found, and how well it fits there: the root of 1 - r^2, of the
 * correlation r of both brightnesses, which does not ask how bright it is or how strong
 * the contrast. 0 is the same, 1 nothing alike; and 1 if more than a quarter of it is outside. */
#ifndef FROB_MATCH_DEFINED
#define FROB_MATCH_DEFINED
struct frob_match {
    struct frob_placement place;
    double residual;
};
#endif

/* How to look for a patch: from where; at which level first (0 … 2: as it is, or as means of 2
 * by 2 or 4 by 4 samples, which see as many times farther); with how many iterations
 * at each level (at most 30); and what may change: 2 the place, 3 also the angle, 4 also
 * the scale, to between half and twice what it was. */
#ifndef FROB_SEARCH_DEFINED
#define FROB_SEARCH_DEFINED
struct frob_search {
    struct frob_placement from;
    int32_t level, iterations, freedom;
};
#endif

/* The place near by that fits best, by least squares (SSD). */
void frob_match_patch(const struct frob_image *image, const double patch[FROB_PATCH_SIZE],
                      const struct frob_search *search, struct frob_match *result);

/* The place in a region that fits best, of those a few samples apart, for a patch with the
 * angle and scale of `like`: where to begin with frob_match_patch at level 2. Regions are
 * looked at as 160 by 120 cells at most. */
void frob_find_template(const struct frob_image *image, const struct frob_region *roi,
                        const double patch[FROB_PATCH_SIZE], const struct frob_placement *like,
                        struct frob_match *result);

/* {1 Distortion} */

/* Where a camera without distortion would see what this one sees at a place; and where
 * this one sees what the other would see there. Beyond what the distortion can be turned
 * back for, undistort gives the place itself. */
void frob_undistort_point(const struct frob_image *image, const struct frob_vec2 *point,
                          struct frob_vec2 *result);
void frob_distort_point(const struct frob_image *image, const struct frob_vec2 *point,
                        struct frob_vec2 *result);

/* {1 Stereo}
 *
 * Of a pair of images of the same size from cameras side by side, without distortion and
 * rectified: what is in a row of the left one is in the same row of the right one, farther to
 * the left by its disparity, which is the larger the nearer it is. */

/* The part of the left image; how many disparities are tried, from 0 (16 … 256, a multiple of
 * 16); and the side of the squares that are compared (5 … 21, odd). Others are rounded to the
 * nearest. */
#ifndef FROB_STEREO_DEFINED
#define FROB_STEREO_DEFINED
struct frob_stereo {
    struct frob_region roi;
    int32_t disparities, window;
};
#endif

/* Bytes of memory that frob_match_stereo needs for a region of this width. */
size_t frob_stereo_room(int32_t width, const struct frob_stereo *how);

/* The disparity of each pixel of the region, in 1/16 pixels; -1 where it is not known: too
 * little texture, two disparities as good as each other, or another one as seen from the
 * right, where that is in the region too. `stride` of these are from one row of the result to
 * the next. False, and nothing written, if the images are no pair, or the room is too small. */
bool frob_match_stereo(const struct frob_image *left, const struct frob_image *right,
                       const struct frob_stereo *how, uint16_t *room, size_t room_size,
                       int16_t *result, int32_t stride);

/* What is seen in a region, in metres along the axis: in each of 16 columns the nearest
 * (that at least 5 % and eight of its pixels have), infinite at disparity 0; and of all of it the
 * nearest, likewise, and the median. NaN where too little is known: fewer pixels than
 * that, or no distance between the cameras. `known` is the share of pixels whose disparity is. */
#ifndef FROB_DEPTHS_DEFINED
#define FROB_DEPTHS_DEFINED
struct frob_depths {
    double known, nearest, median;
    double columns[16];
};
#endif

/* Regions are cut to 640 columns in their middle, disparities to 64; the stack is 350 kB. */
void frob_stereo_depths(const struct frob_image *left, const struct frob_image *right,
                        const struct frob_stereo *how, struct frob_depths *result);

/* {1 Tags} */

/* An AprilTag as it was found in an image: its number, its middle, and the corners of its black
 * frame, counter-clockwise as one looks at it, from the lower left one of an upright tag. `margin`
 * is by how much brightness tells its cells apart, 0 … 255. */
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

/* Where a tag is in space, seen from the camera: x to the right, y down, z ahead. Its middle, in
 * metres; the direction in which it looks, which is towards the camera; how far the corners of
 * such a tag are from those that were found, in pixels (the root of the mean square); and how
 * much the other of the two poses in which it looks nearly alike is to be thought of: that one's
 * residual divides this one's, so 0 is certain and 1 is a guess. */
#ifndef FROB_TAG_PLACE_DEFINED
#define FROB_TAG_PLACE_DEFINED
struct frob_tag_place {
    struct frob_vec3 middle, facing;
    double residual, ambiguity;
};
#endif

struct frob_lens;

/* Of a tag whose black frame is `size` wide and high, by least squares of the corners' distances,
 * without the lens's distortion. All NaN if there is no such tag: corners that are in a line or
 * the wrong way round, a size that is not above 0. */
void frob_find_tag_place(const struct frob_lens *lens, double size, const struct frob_tag *tag,
                         struct frob_tag_place *result);

#ifdef __cplusplus
}
#endif
#endif
