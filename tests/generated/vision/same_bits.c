/* Prints one number for each kernel that summarizes its results on random images. It must be the
 * same for all compilers, their options, and the versions of loops for newer processors. */
#include "picture.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

static uint64_t hash;

static void add(double x)
{
    uint64_t bits;

    memcpy(&bits, &x, sizeof bits);
    hash = (hash ^ bits) * UINT64_C(0x100000001b3);
    hash ^= hash >> 29;
}

static void add_blob(const struct frob_blob *b)
{
    add(b->pixels);
    add(b->cx);
    add(b->cy);
    add(b->box.x);
    add(b->box.width);
    add(b->major);
    add(b->minor);
    add(b->rotation);
}

static void add_match(const struct frob_match *m)
{
    add(m->place.x);
    add(m->place.y);
    add(m->place.angle);
    add(m->place.scale);
    add(m->residual);
}

enum { KERNELS = 10, IMAGES = 200 };

static const char *const names[KERNELS] = { "find_blob",    "find_blobs",    "get_statistics",
                                            "find_edges",   "find_corner",   "get_patch",
                                            "match_patch",  "find_template", "undistort_point",
                                            "stereo_depths" };

/* The view of a camera 0.1 m to the right, facing a wall at a disparity of 5 pixels. */
static const struct frob_image *shifted(const struct frob_image *image)
{
    static struct frob_image seen;
    static uint8_t pixels[128 * 128 * 3];

    seen = *image;
    seen.pixels = pixels;
    seen.camera.y_m -= 0.1;
    for (int32_t y = 0; y < image->height && image->format != FROB_DEPTH_M; y++)
        for (int32_t x = 0; x < image->width * frob_image_pixel_size(image->format); x++) {
            const int32_t from = x + 5 * frob_image_pixel_size(image->format);
            pixels[y * image->stride + x] =
                from < image->stride && from < image->width * frob_image_pixel_size(image->format)
                    ? frob_image_row(image, y)[from]
                    : 0;
        }
    return &seen;
}

static void run(int kernel, const struct frob_image *image)
{
    const struct frob_region roi = random_region(image);
    const struct frob_colour_range colours = { 0.5, 4.0, 0.2, 1, 0.1, 0.9 };
    const struct frob_segment segment = { 30, 20, 0.7, 30, 5 };
    const struct frob_placement place = { 30.2, 25.4, 0.3, 0.9 }, near = { 31.4, 24.6, 0.35, 0.95 };
    const struct frob_search search = { near, 2, 8, 4 };
    const struct frob_vec2 point = { 12.5, 33.25 };
    struct frob_blob blob;
    struct frob_blobs blobs;
    struct frob_statistics s;
    struct frob_edges edges;
    struct frob_corner corner;
    double patch[FROB_PATCH_SIZE];
    struct frob_match match;
    struct frob_vec2 moved;
    struct frob_stereo how = { { 0, 0, 0, 0 }, 32, 9 };
    struct frob_depths depths;

    switch (kernel) {
    case 0:
        frob_find_blob(image, &roi, &colours, &blob);
        add_blob(&blob);
        break;
    case 1:
        frob_find_blobs(image, &roi, &colours, &blobs);
        for (int i = 0; i < 8; i++)
            add_blob(&blobs.largest[i]);
        break;
    case 2:
        frob_get_statistics(image, &roi, &s);
        add(s.mean);
        add(s.stdev);
        add(s.median);
        break;
    case 3:
        frob_find_edges(image, &segment, &edges);
        add(edges.rising.offset);
        add(edges.rising.gradient);
        add(edges.falling.offset);
        break;
    case 4:
        frob_find_corner(image, &roi, &corner);
        add(corner.x);
        add(corner.y);
        add(corner.score);
        break;
    case 9:
        how.roi = roi;
        frob_stereo_depths(image, image, &how, &depths);
        add(depths.known);
        frob_stereo_depths(image, shifted(image), &how, &depths);
        add(depths.known);
        for (int i = 0; i < 16; i++)
            add(depths.columns[i] > 0 ? depths.columns[i] : -1);
        break;
    case 8:
        frob_undistort_point(image, &point, &moved);
        add(moved.x);
        add(moved.y);
        break;
    default:
        frob_get_patch(image, &place, patch);
        for (int i = 0; i < FROB_PATCH_SIZE && kernel == 5; i++)
            add(patch[i]);
        if (kernel == 6)
            frob_match_patch(image, patch, &search, &match);
        if (kernel == 7)
            frob_find_template(image, &roi, patch, &near, &match);
        if (kernel > 5)
            add_match(&match);
        break;
    }
}

int main(void)
{
    for (int kernel = 0; kernel < KERNELS; kernel++) {
        hash = UINT64_C(0xcbf29ce484222325);
        for (int k = 0; k < IMAGES; k++) {
            struct frob_image *image = random_picture(80);
            image->camera.k1 = -0.2;
            image->camera.p1 = 0.001;
            run(kernel, image);
            picture_free(image);
        }
        printf("%-16s %016" PRIx64 "\n", names[kernel], hash);
    }
    return 0;
}
