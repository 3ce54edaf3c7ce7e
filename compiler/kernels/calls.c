#include "calls.h"

#include <frob/lens.h>
#include <frob/vision.h>

#include <string.h>

#define IMAGE(k) ((const struct frob_image *)arguments[k])

static void image_lens(const void *const *arguments, void *result)
{
    frob_image_lens(IMAGE(0), (struct frob_lens *)result);
}

static void image_key(const void *const *arguments, void *result)
{
    const int32_t key = frob_image_key(IMAGE(0));
    memcpy(result, &key, sizeof key);
}

#define REGION(k) ((const struct frob_region *)arguments[k])
#define COLOURS(k) ((const struct frob_colour_range *)arguments[k])

static void find_blob(const void *const *arguments, void *result)
{
    frob_find_blob(IMAGE(0), REGION(1), COLOURS(2), (struct frob_blob *)result);
}

static void find_blobs(const void *const *arguments, void *result)
{
    frob_find_blobs(IMAGE(0), REGION(1), COLOURS(2), (struct frob_blobs *)result);
}

static void get_statistics(const void *const *arguments, void *result)
{
    frob_get_statistics(IMAGE(0), REGION(1), (struct frob_statistics *)result);
}

static void get_histogram(const void *const *arguments, void *result)
{
    frob_get_histogram(IMAGE(0), REGION(1), (int32_t *)result);
}

static void find_edges(const void *const *arguments, void *result)
{
    frob_find_edges(IMAGE(0), (const struct frob_segment *)arguments[1],
                    (struct frob_edges *)result);
}

static void find_corner(const void *const *arguments, void *result)
{
    frob_find_corner(IMAGE(0), REGION(1), (struct frob_corner *)result);
}

static void get_patch(const void *const *arguments, void *result)
{
    frob_get_patch(IMAGE(0), (const struct frob_placement *)arguments[1], (double *)result);
}

static void match_patch(const void *const *arguments, void *result)
{
    frob_match_patch(IMAGE(0), (const double *)arguments[1],
                     (const struct frob_search *)arguments[2], (struct frob_match *)result);
}

static void find_template(const void *const *arguments, void *result)
{
    frob_find_template(IMAGE(0), REGION(1), (const double *)arguments[2],
                       (const struct frob_placement *)arguments[3], (struct frob_match *)result);
}

#define POINT(k) ((const struct frob_vec2 *)arguments[k])

static void undistort_point(const void *const *arguments, void *result)
{
    frob_undistort_point(IMAGE(0), POINT(1), (struct frob_vec2 *)result);
}

static void distort_point(const void *const *arguments, void *result)
{
    frob_distort_point(IMAGE(0), POINT(1), (struct frob_vec2 *)result);
}

static void stereo_depths(const void *const *arguments, void *result)
{
    frob_stereo_depths(IMAGE(0), IMAGE(1), (const struct frob_stereo *)arguments[2],
                       (struct frob_depths *)result);
}

static void find_tag_place(const void *const *arguments, void *result)
{
    double size;
    memcpy(&size, arguments[1], sizeof size);
    frob_find_tag_place((const struct frob_lens *)arguments[0], size,
                        (const struct frob_tag *)arguments[2], (struct frob_tag_place *)result);
}

const struct kernel frob_kernels[] = {
    { "frob_distort_point", distort_point },
    { "frob_find_blob", find_blob },
    { "frob_find_blobs", find_blobs },
    { "frob_find_corner", find_corner },
    { "frob_find_edges", find_edges },
    { "frob_find_tag_place", find_tag_place },
    { "frob_find_template", find_template },
    { "frob_get_histogram", get_histogram },
    { "frob_get_patch", get_patch },
    { "frob_get_statistics", get_statistics },
    { "frob_image_key", image_key },
    { "frob_image_lens", image_lens },
    { "frob_match_patch", match_patch },
    { "frob_stereo_depths", stereo_depths },
    { "frob_undistort_point", undistort_point },
};

const size_t frob_kernel_count = sizeof frob_kernels / sizeof frob_kernels[0];
