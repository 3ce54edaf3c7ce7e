/* Tests stereo against a slow version on random pairs, to the bit, and against drawn depths. */
#include "picture.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 72 };

/* ---- The slow version */

static int32_t grey(const struct frob_image *image, int32_t x, int32_t y)
{
    const int32_t column = x < 0 ? 0 : x >= image->width ? image->width - 1 : x;
    const int32_t row = y < 0 ? 0 : y >= image->height ? image->height - 1 : y;
    const uint8_t *p = frob_image_row(image, row) + column * frob_image_pixel_size(image->format);
    return image->format == FROB_RGB8 ? (77 * p[0] + 150 * p[1] + 29 * p[2] + 128) / 256 : p[0];
}

static int32_t change(const struct frob_image *image, int32_t x, int32_t y)
{
    const int32_t column = x < 0 ? 0 : x >= image->width ? image->width - 1 : x;
    const int32_t row = y < 0 ? 0 : y >= image->height ? image->height - 1 : y;
    int32_t sum = 0;
    if (column == 0 || column == image->width - 1)
        return 0;
    for (int32_t i = -1; i <= 1; i++)
        sum += (i == 0 ? 2 : 1) *
               (grey(image, column + 1, row + i) - grey(image, column - 1, row + i));
    return sum < -31 ? -31 : sum > 31 ? 31 : sum;
}

static int32_t cost(const struct frob_image *left, const struct frob_image *right, int32_t around,
                    int32_t x, int32_t y, int32_t d)
{
    int32_t sum = 0;
    for (int32_t j = -around; j <= around; j++)
        for (int32_t i = -around; i <= around; i++)
            sum += abs(change(left, x + i, y + j) - change(right, x + i - d, y + j));
    return sum;
}

static int32_t slow(const struct frob_image *left, const struct frob_image *right, int32_t first,
                    int32_t last, int32_t all, int32_t around, int32_t x, int32_t y)
{
    int32_t sums[256], best = 0, texture = 0, right_best = INT32_MAX, other = 0;
    const int32_t window = 2 * around + 1;
    for (int32_t d = 0; d < all; d++) {
        sums[d] = cost(left, right, around, x, y, d);
        best = sums[d] < sums[best] ? d : best;
    }
    for (int32_t d = 0; d < all; d++)
        if (abs(d - best) > 1 && sums[d] <= sums[best] + sums[best] / 10)
            return -1;
    for (int32_t j = -around; j <= around; j++)
        for (int32_t i = -around; i <= around; i++)
            texture += abs(change(left, x + i, y + j));
    if (16 * texture <= 10 * window * window || x - best < 0)
        return -1;
    for (int32_t d = 0; d < all && x - best >= first && x - best + d <= last; d++) {
        const int32_t seen = cost(left, right, around, x - best + d, y, d);
        if (seen < right_best) {
            right_best = seen;
            other = d;
        }
    }
    if (x - best >= first && abs(best - other) > 1)
        return -1;
    if (best == 0 || best == all - 1)
        return 16 * best;
    {
        const double a = sums[best - 1], b = sums[best], c = sums[best + 1];
        const double slope = fmax(a, c) - b;
        const double part = slope > 0 ? 8 * fabs(a - c) / slope : 0;
        return 16 * best + (a > c ? 1 : -1) * (int32_t)floor(part + 0.5);
    }
}

static void as_the_slow_version(void)
{
    static int16_t found[SIDE * SIDE];
    int known = 0;

    for (int k = 0; k < 12; k++) {
        const enum frob_image_format format = k % 3 ? FROB_GREY8 : FROB_RGB8;
        struct frob_image *left = picture(20 + random_below(50), 3 + random_below(12), format);
        struct frob_image *right = picture(left->width, left->height, format);
        const struct frob_stereo how = { { k % 2 ? 0 : random_below(10),
                                           k % 2 ? 0 : random_below(3), k % 2 ? 100 : 30, 100 },
                                         16 + 16 * random_below(2),
                                         5 + 2 * random_below(4) };
        const int32_t size = frob_image_pixel_size(format);
        const size_t room_size = frob_stereo_room(left->width, &how);
        uint16_t *room = malloc(room_size);
        uint8_t *a = (uint8_t *)(uintptr_t)left->pixels, *b = (uint8_t *)(uintptr_t)right->pixels;
        const int32_t shift = random_below(9);
        for (int32_t i = 0; i < left->stride * left->height; i++)
            a[i] = (uint8_t)(random_below(60) + (i / 40 % 3) * 60);
        for (int32_t i = 0; i < left->stride * left->height; i++)
            b[i] = (uint8_t)((i % left->stride) + shift * size < left->stride
                                 ? a[i + shift * size] + random_below(4)
                                 : random_below(256));
        check(frob_match_stereo(left, right, &how, room, room_size, found, SIDE), "matched", 0, 1);
        for (int32_t y = (int32_t)how.roi.y; y < left->height; y++)
            for (int32_t x = (int32_t)how.roi.x; x < left->width && x < how.roi.x + how.roi.width;
                 x++) {
                const int32_t last = (int32_t)fmin(left->width, how.roi.x + how.roi.width) - 1;
                const int32_t expected = slow(left, right, (int32_t)how.roi.x, last,
                                              how.disparities, how.window / 2, x, y);
                const int16_t is = found[(y - (int32_t)how.roi.y) * SIDE + x - (int32_t)how.roi.x];
                check(is == expected, "disparity", is, expected);
                known += is >= 0;
            }
        check(!frob_match_stereo(left, right, &how, room, room_size / 4, found, SIDE),
              "a room too small", 1, 0);
        free(room);
        picture_free(left);
        picture_free(right);
    }
    check(known > 1000, "known disparities", known, 1000);
}

/* ---- Depths */

/* A slanted wall, by its disparity at column x of the left image. */
struct wall {
    double near, slope, seed;
    bool from_right;
};

static double wall_texture(double u, double v)
{
    double sum = 0;
    for (int k = 1; k <= 5; k++)
        sum += sin(0.31 * k * u + 1.7 * k + sin(0.23 * v * k)) + sin(0.27 * k * v + 0.5 * u);
    return 128 + 22 * sum > 255 ? 255 : 128 + 22 * sum < 0 ? 0 : 128 + 22 * sum;
}

/* The pixel at x in the right image is at x + near + slope * (that place) in the left one. */
static double wall_shade(const void *scene, double x, double y)
{
    const struct wall *w = (const struct wall *)scene;
    return wall_texture(w->from_right ? (x + w->near) / (1 - w->slope) : x, y);
}

static void depths_that_were_drawn(void)
{
    const struct wall truths[] = {
        { 8, 0, 0, false }, { 12.25, 0, 0, false }, { 6, 0.06, 0, false }, { 20.6, -0.02, 0, false }
    };

    for (size_t k = 0; k < sizeof truths / sizeof *truths; k++) {
        struct frob_image *left = picture(160, 60, FROB_GREY8);
        struct frob_image *right = picture(160, 60, FROB_GREY8);
        const struct frob_stereo how = { { 40, 0, 112, 60 }, 32, 9 };
        struct wall w = truths[k];
        struct frob_depths depths;
        draw(left, 3, wall_shade, &w);
        w.from_right = true;
        draw(right, 3, wall_shade, &w);
        left->camera.y_m = 0.05;
        right->camera.y_m = -0.05;
        left->camera.focal_x = right->camera.focal_x = 150;
        frob_stereo_depths(left, right, &how, &depths);
        check(depths.known > 0.8, "known", depths.known, 1);
        for (int i = 0; i < 16; i++) {
            /* The nearest end of the column, slightly inside. */
            const double end = w.slope > 0 ? 40 + 7 * (i + 1) : 40 + 7 * i;
            const double truth = 0.1 * 150 / (w.near + w.slope * end);
            check(fabs(depths.columns[i] / truth - 1) < 0.05, "a column's depth, m",
                  depths.columns[i], truth);
        }
        check(fabs(depths.median / (15 / (w.near + w.slope * 96)) - 1) < 0.03, "median, m",
              depths.median, 15 / (w.near + w.slope * 96));
        picture_free(left);
        picture_free(right);
    }
}

static void nothing_to_see(void)
{
    struct frob_image *left = picture(64, 48, FROB_GREY8), *right = picture(64, 48, FROB_GREY8);
    struct frob_image *narrow = picture(63, 48, FROB_GREY8);
    const struct frob_stereo how = { everywhere, 32, 9 };
    struct frob_depths depths;

    left->camera.y_m = 0.1;
    frob_stereo_depths(left, right, &how, &depths);
    check(depths.known == 0 && isnan(depths.nearest) && isnan(depths.columns[3]), "a blank wall",
          depths.known, 0);
    frob_stereo_depths(left, narrow, &how, &depths);
    check(depths.known == 0 && isnan(depths.median), "no pair", depths.known, 0);
    picture_free(left);
    picture_free(right);
    picture_free(narrow);
}

static void any_arguments(void)
{
    for (int k = 0; k < 400; k++) {
        struct frob_image *left = random_picture(60), *right = random_picture(60);
        const struct frob_stereo how = { random_region(left), (int32_t)random_bits(),
                                         random_below(2) ? (int32_t)random_bits() : 9 };
        struct frob_depths depths;
        if (random_below(4) > 0) {
            picture_free(right);
            right = picture(left->width, left->height, left->format);
        }
        left->camera.y_m = random_number();
        frob_stereo_depths(left, right, &how, &depths);
        check(depths.known >= 0 && depths.known <= 1, "known", depths.known, 0);
        check(!(depths.nearest < 0) && !(depths.median < depths.nearest), "depths", depths.nearest,
              depths.median);
        picture_free(left);
        picture_free(right);
    }
}

int main(void)
{
    as_the_slow_version();
    depths_that_were_drawn();
    nothing_to_see();
    any_arguments();
    printf("stereo: %d failures\n", failures());
    return failures() > 0;
}
