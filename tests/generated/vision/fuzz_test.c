/* Calls the kernels with arbitrary arguments: they must not read outside an image or overflow,
 * and results must have the promised properties. Runs with sanitizers. */
#include "picture.h"

#include <frob/lens.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* ---- Invalid images */

static void spoil(struct frob_image *image)
{
    switch (random_below(6)) {
    case 0: image->width = -1 - random_below(1000); break;
    case 1: image->height = INT32_MIN; break;
    case 2:
        image->stride = random_below(2) ? INT32_MIN : image->width - 1;
        if (image->stride >= image->width * frob_image_pixel_size(image->format))
            image->stride = -1;
        break;
    case 3: image->width = INT32_MAX; break;
    case 4: image->format = (enum frob_image_format)3; break;
    default:
        image->width = image->height = 4;
        free((void *)(uintptr_t)image->pixels);
        image->pixels = NULL;
        break;
    }
}

static struct frob_image *any_picture(bool *is_sound)
{
    struct frob_image *image = random_picture(48);

    *is_sound = random_below(8) > 0;
    if (!*is_sound)
        spoil(image);
    check(frob_image_is_sound(image) == *is_sound, "sound", *is_sound, *is_sound);
    image->camera.focal_x = random_number();
    image->camera.focal_y = random_number();
    image->camera.k1 = random_below(2) ? random_number() : 0;
    image->camera.k2 = random_below(2) ? random_number() : 0;
    image->camera.p1 = random_below(2) ? random_number() : 0;
    return image;
}

/* ---- Promised properties */

static void check_share(double x, const char *what)
{
    check(x >= 0 && x <= 1, what, x, 0);
}

static void check_in_image(const struct frob_image *image, double x, double y, const char *what)
{
    check(x >= -0.5 && x <= image->width - 0.5, what, x, image->width);
    check(y >= -0.5 && y <= image->height - 0.5, what, y, image->height);
}

static struct frob_placement any_placement(const struct frob_image *image)
{
    struct frob_placement p = { random_number(), random_number(), random_number(),
                                random_number() };

    if (random_below(2) && image->width > 0 && image->height > 0) {
        p.x = random_below(48);
        p.y = random_below(48);
        p.angle = 6 * random_share();
        p.scale = 0.2 + 3 * random_share();
    }
    return p;
}

/* A valid placement is in front of the camera and faces it. */
static void tags(void)
{
    struct frob_lens lens = { 0 };
    struct frob_tag tag = { 0 };
    struct frob_tag_place place;
    const double size = random_number();
    lens.focalX = random_number();
    lens.focalY = random_below(2) ? lens.focalX : random_number();
    lens.centreX = random_number();
    lens.k1 = random_below(2) ? 0 : random_number();
    for (int i = 0; i < 4; i++) {
        tag.corners[i].x = random_below(4) ? random_below(40) : random_number();
        tag.corners[i].y = random_below(4) ? random_below(40) : random_number();
    }
    frob_find_tag_place(&lens, size, &tag, &place);
    if (isnan(place.residual)) {
        check(isnan(place.middle.z) && isnan(place.facing.x), "no place", place.middle.z, NAN);
        return;
    }
    check(place.middle.z > 0 && place.residual >= 0, "a place", place.middle.z, place.residual);
    check_share(place.ambiguity, "ambiguity");
    check(fabs(place.facing.x * place.facing.x + place.facing.y * place.facing.y +
               place.facing.z * place.facing.z - 1) < 1e-9,
          "a direction", place.facing.z, 1);
}

static void kernels(const struct frob_image *image, bool is_sound)
{
    const struct frob_region roi = { random_number(), random_number(), random_number(),
                                     random_number() };
    const struct frob_region *where = random_below(2) ? &everywhere : &roi;
    const struct frob_colour_range colours = { random_number(), random_number(), random_number(),
                                               random_number(), random_number(), random_number() };
    const struct frob_segment segment = { random_number(), random_number(), random_number(),
                                          random_number(), random_number() };
    const struct frob_vec2 point = { random_number(), random_number() };
    const struct frob_placement place = any_placement(image);
    const struct frob_search search = { any_placement(image), random_below(9) - 3,
                                        random_below(9) ? random_below(12) : INT32_MAX,
                                        random_below(9) - 2 };
    struct frob_blob blob;
    struct frob_blobs blobs;
    struct frob_statistics statistics;
    int32_t counts[256];
    struct frob_edges edges;
    struct frob_corner corner;
    double patch[FROB_PATCH_SIZE];
    struct frob_match match;
    struct frob_vec2 moved;

    frob_find_blob(image, where, &colours, &blob);
    frob_find_blobs(image, where, &colours, &blobs);
    check(blobs.count == 0 || blobs.largest[0].pixels <= blob.pixels, "the largest of them",
          blobs.largest[0].pixels, blob.pixels);
    check(is_sound || blob.pixels == 0, "no pixels", blob.pixels, 0);
    if (blob.pixels > 0) {
        check_in_image(image, blob.cx, blob.cy, "centre");
        check(blob.minor > 0 && blob.major >= blob.minor, "axes", blob.major, blob.minor);
        check(fabs(blob.rotation) <= 1.5707963267948966, "rotation", blob.rotation, 0);
    }
    frob_get_statistics(image, where, &statistics);
    check(isfinite(statistics.mean) && isfinite(statistics.stdev), "a mean", statistics.mean, 0);
    check(statistics.min <= statistics.median && statistics.median <= statistics.max, "median",
          statistics.median, statistics.min);
    frob_get_histogram(image, where, counts);
    frob_find_edges(image, &segment, &edges);
    check(edges.rising.gradient >= 0 && edges.rising.gradient < 255, "rise", edges.rising.gradient,
          0);
    check(edges.falling.gradient <= 0 && edges.falling.gradient > -255, "fall",
          edges.falling.gradient, 0);
    check(fabs(edges.rising.offset) <= 64.5, "offset", edges.rising.offset, 0);
    frob_find_corner(image, where, &corner);
    check(corner.score >= 0 && corner.score < 1e6, "score", corner.score, 0);
    if (corner.score > 0)
        check_in_image(image, corner.x, corner.y, "corner");
    frob_get_patch(image, &place, patch);
    for (int i = 0; i < FROB_PATCH_SIZE; i++)
        check(patch[i] >= 0 && patch[i] <= 255, "a sample", patch[i], 0);
    if (random_below(4) == 0)
        for (int i = 0; i < FROB_PATCH_SIZE; i++)
            patch[i] = random_number();
    frob_match_patch(image, patch, &search, &match);
    check_share(match.residual, "residual");
    frob_find_template(image, where, patch, &place, &match);
    check_share(match.residual, "residual");
    if (match.residual < 1)
        check_in_image(image, match.place.x, match.place.y, "template");
    tags();
    frob_undistort_point(image, &point, &moved);
    frob_distort_point(image, &point, &moved);
}

int main(void)
{
    for (int k = 0; k < 6000; k++) {
        bool is_sound;
        struct frob_image *image = any_picture(&is_sound);
        kernels(image, is_sound);
        picture_free(image);
    }
    printf("any arguments: %d failures\n", failures());
    return failures() > 0;
}
