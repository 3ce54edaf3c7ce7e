/* Tests blob detection against textbook hue formulas, sums over pixels, and a flood fill. */
#include "picture.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 64 };

static const double degree = 0.017453292519943295;

static bool is_inside(const struct frob_region *roi, int32_t x, int32_t y)
{
    return x >= roi->x && x < roi->x + roi->width && y >= roi->y && y < roi->y + roi->height;
}

/* Whether the kernel finds a single pixel. */
static bool is_found(const struct frob_image *image, int32_t x, int32_t y,
                     const struct frob_colour_range *colours)
{
    const struct frob_region roi = { x, y, 1, 1 };
    struct frob_blob blob;
    frob_find_blob(image, &roi, colours, &blob);
    return blob.pixels == 1;
}

/* Whether a colour is in a range, by the textbook formulas: 1, 0, or -1 if it is so close to a
 * limit that either is acceptable. */
static int by_the_book(const uint8_t *p, const struct frob_colour_range *c)
{
    const double r = p[0], g = p[1], b = p[2];
    const double value = fmax(r, fmax(g, b)), chroma = value - fmin(r, fmin(g, b));
    const double saturation = value > 0 ? chroma / value : 0;
    const double past = c->hueTo - c->hueFrom;
    double hue = 0, distance;
    bool unsure = false, in = true;

    if (chroma > 0)
        hue = 60 * degree *
              (value == r   ? (g - b) / chroma
               : value == g ? 2 + (b - r) / chroma
                            : 4 + (r - g) / chroma);
    if (chroma > 0 && past < 360 * degree) {
        distance = fmod(hue - c->hueFrom + 720 * degree, 360 * degree);
        in = distance <= past;
        unsure = fabs(distance - past) < 0.6 * degree || distance < 0.6 * degree ||
                 distance > 359.4 * degree;
    }
    if (fabs(saturation - c->saturationFrom) < 1.01 / 128 ||
        fabs(saturation - c->saturationTo) < 1.01 / 128)
        unsure = true;
    in = in && saturation >= c->saturationFrom && saturation <= c->saturationTo;
    if (value / 255 < c->valueFrom || value / 255 > c->valueTo)
        return 0;
    return unsure ? -1 : in;
}

static void colours_are_those_of_the_book(void)
{
    struct frob_image *image = picture(1, 1, FROB_RGB8);
    uint8_t *pixel = (uint8_t *)(uintptr_t)image->pixels;
    int sure = 0, in = 0;

    for (int k = 0; k < 200000; k++) {
        const double from = random_below(720) - 360;
        const struct frob_colour_range c = {
            from * degree,        (from + random_below(360)) * degree, random_share() * 0.8, 1,
            random_share() * 0.5, 0.6 + random_share() * 0.4
        };
        int expected, found;
        for (int i = 0; i < 3; i++)
            pixel[i] = (uint8_t)random_below(256);
        expected = by_the_book(pixel, &c);
        found = is_found(image, 0, 0, &c);
        check(expected < 0 || expected == found, "colour in a range", found, expected);
        sure += expected >= 0;
        in += expected == 1;
    }
    check(sure > 150000 && in > 10000, "colours that say something", in, 10000);
    picture_free(image);
}

static void ends_of_ranges(void)
{
    static const uint8_t red[3] = { 255, 0, 0 }, grey[3] = { 102, 102, 102 },
                         cyan[3] = { 0, 255, 255 };
    struct frob_image *image = picture(1, 1, FROB_RGB8);
    const struct frob_colour_range around_red = { 350 * degree, 10 * degree, 0.5, 1, 0, 1 };
    const struct frob_colour_range red_alone = { 0, 0, 0.5, 1, 0, 1 };
    const struct frob_colour_range all = { 0, 360 * degree, 0, 1, 0.4, 0.4 };
    const struct frob_colour_range none = { 0, 360 * degree, 0.6, 0.5, 0, 1 };
    const struct frob_colour_range unknown = { NAN, 1, 0, 1, 0, 1 };

    memcpy((void *)(uintptr_t)image->pixels, red, 3);
    check(is_found(image, 0, 0, &around_red), "red around 0", 0, 1);
    check(is_found(image, 0, 0, &red_alone), "red at 0", 0, 1);
    check(!is_found(image, 0, 0, &none), "ends the wrong way round", 1, 0);
    check(!is_found(image, 0, 0, &unknown), "an end that is NaN", 1, 0);
    memcpy((void *)(uintptr_t)image->pixels, cyan, 3);
    check(!is_found(image, 0, 0, &red_alone), "cyan, opposite of red", 1, 0);
    memcpy((void *)(uintptr_t)image->pixels, grey, 3);
    check(is_found(image, 0, 0, &all), "102 of 255 is 0.4", 0, 1);
    picture_free(image);
}

/* ---- Sums */

static bool mask[SIDE][SIDE];

static void compare(const struct frob_blob *found, const bool (*set)[SIDE])
{
    double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
    double left = SIDE, top = SIDE, right = -1, bottom = -1;

    for (int32_t r = 0; r < SIDE; r++)
        for (int32_t c = 0; c < SIDE; c++)
            if (set[r][c]) {
                n++;
                x += c;
                y += r;
                left = fmin(left, c);
                right = fmax(right, c);
                top = fmin(top, r);
                bottom = fmax(bottom, r);
            }
    check(found->pixels == n, "pixels", found->pixels, n);
    if (n == 0 || found->pixels != n)
        return;
    x /= n;
    y /= n;
    for (int32_t r = 0; r < SIDE; r++)
        for (int32_t c = 0; c < SIDE; c++)
            if (set[r][c]) {
                xx += (c - x) * (c - x) / n;
                xy += (c - x) * (r - y) / n;
                yy += (r - y) * (r - y) / n;
            }
    check(fabs(found->cx - x) < 1e-9, "cx", found->cx, x);
    check(fabs(found->cy - y) < 1e-9, "cy", found->cy, y);
    check(found->box.x == left, "box.x", found->box.x, left);
    check(found->box.y == top, "box.y", found->box.y, top);
    check(found->box.width == right - left + 1, "box.width", found->box.width, right - left + 1);
    check(found->box.height == bottom - top + 1, "box.height", found->box.height, bottom - top + 1);
    /* Converts the axes back to moments. */
    {
        const double a = found->major * found->major / 16, b = found->minor * found->minor / 16;
        const double c = cos(found->rotation), s = sin(found->rotation);
        check(fabs(a * c * c + b * s * s - xx - 1.0 / 12) < 1e-6, "xx", found->major, xx);
        check(fabs(a * s * s + b * c * c - yy - 1.0 / 12) < 1e-6, "yy", found->major, yy);
        check(fabs((a - b) * c * s - xy) < 1e-6, "xy", found->rotation, xy);
        check(found->major >= found->minor && found->minor > 0, "minor", found->minor,
              found->major);
    }
}

/* ---- Components, by a flood fill */

static int flood(bool (*component)[SIDE], int32_t x, int32_t y)
{
    static int32_t to_do[SIDE * SIDE * 9][2];
    int waiting = 0, pixels = 0;

    to_do[waiting][0] = x;
    to_do[waiting++][1] = y;
    while (waiting > 0) {
        const int32_t c = to_do[--waiting][0], r = to_do[waiting][1];
        if (c < 0 || r < 0 || c >= SIDE || r >= SIDE || !mask[r][c])
            continue;
        mask[r][c] = false;
        component[r][c] = true;
        pixels++;
        for (int32_t i = -1; i <= 1; i++)
            for (int32_t j = -1; j <= 1; j++) {
                to_do[waiting][0] = c + i;
                to_do[waiting++][1] = r + j;
            }
    }
    return pixels;
}

/* Removes each component from the mask. The largest ones must be those that the kernel found. */
static void compare_components(const struct frob_blobs *found)
{
    static bool component[SIDE][SIDE];
    int32_t sizes[SIDE * SIDE], count = 0;

    for (int32_t y = 0; y < SIDE; y++)
        for (int32_t x = 0; x < SIDE; x++)
            if (mask[y][x]) {
                int matches = 0;
                memset(component, 0, sizeof component);
                sizes[count++] = flood(component, x, y);
                for (int32_t k = 0; k < found->count; k++) {
                    const struct frob_blob *b = &found->largest[k];
                    /* y is its first row, x its first column in this row */
                    if (b->pixels == sizes[count - 1] && b->box.y == y && b->box.x <= x &&
                        x < b->box.x + b->box.width && matches == 0) {
                        const int before = failures();
                        compare(b, (const bool(*)[SIDE])component);
                        matches += failures() == before;
                    }
                }
            }
    for (int32_t k = 0; k < 8; k++) {
        int32_t best = 0;
        for (int32_t i = 1; i < count; i++)
            best = sizes[i] > sizes[best] ? i : best;
        if (k < count) {
            check(found->largest[k].pixels == sizes[best], "the largest in order",
                  found->largest[k].pixels, sizes[best]);
            sizes[best] = 0;
        } else {
            check(found->largest[k].pixels == 0, "none", found->largest[k].pixels, 0);
        }
    }
    check(found->count == (count < 8 ? count : 8), "count", found->count, count);
}

static void random_images(void)
{
    for (int k = 0; k < 3000; k++) {
        struct frob_image *image = random_picture(SIDE);
        const struct frob_region roi = random_region(image);
        const double from = random_below(360);
        const struct frob_colour_range c = { from * degree,
                                             (from + random_below(360)) * degree,
                                             image->format == FROB_GREY8 ? 0 : random_share() * 0.5,
                                             1,
                                             random_share(),
                                             1 };
        struct frob_blob blob;
        struct frob_blobs blobs;
        int set = 0;
        for (int32_t y = 0; y < SIDE; y++)
            for (int32_t x = 0; x < SIDE; x++) {
                mask[y][x] = x < image->width && y < image->height && is_inside(&roi, x, y) &&
                             is_found(image, x, y, &c);
                set += mask[y][x];
            }
        frob_find_blob(image, &roi, &c, &blob);
        compare(&blob, (const bool(*)[SIDE])mask);
        frob_find_blobs(image, &roi, &c, &blobs);
        compare_components(&blobs);
        if (image->format == FROB_DEPTH_M)
            check(set == 0, "colours of depths", set, 0);
        picture_free(image);
    }
}

/* ---- Drawn images */

struct disc {
    double x, y, radius;
};

static double disc_shade(const void *scene, double x, double y)
{
    const struct disc *d = (const struct disc *)scene;
    return hypot(x - d->x, y - d->y) < d->radius ? 255 : 0;
}

static void discs(void)
{
    const struct frob_colour_range bright = { 0, 6.3, 0, 1, 0.5, 1 };
    double worst = 0;

    for (int k = 0; k < 50; k++) {
        struct frob_image *image = picture(SIDE, SIDE, FROB_GREY8);
        const struct disc d = { 20 + 20 * random_share(), 20 + 20 * random_share(),
                                8 + 10 * random_share() };
        struct frob_blob blob;
        draw(image, 16, disc_shade, &d);
        frob_find_blob(image, &everywhere, &bright, &blob);
        worst = fmax(worst, hypot(blob.cx - d.x, blob.cy - d.y));
        check(fabs(sqrt(blob.major * blob.minor) - 2 * d.radius) < 0.3, "diameter", blob.major,
              2 * d.radius);
        check(blob.major < 1.03 * blob.minor, "round", blob.major, blob.minor);
        picture_free(image);
    }
    check(worst < 0.12, "centres of discs, px", worst, 0.12);
}

/* Spirals and combs have the maximum number of runs in a row, and their parts join late. */
static void combs(void)
{
    const struct frob_colour_range bright = { 0, 6.3, 0, 1, 0.5, 1 };
    struct frob_image *image = picture(FROB_IMAGE_SIDE, 5, FROB_GREY8);
    uint8_t *pixels = (uint8_t *)(uintptr_t)image->pixels;
    struct frob_blobs blobs;

    for (int32_t y = 0; y < 5; y++)
        for (int32_t x = 0; x < FROB_IMAGE_SIDE; x++)
            pixels[y * image->stride + x] = (y == 4 || x % 2 == 0) && y != 2 ? 255 : 0;
    frob_find_blobs(image, &everywhere, &bright, &blobs);
    check(blobs.count == 8, "combs", blobs.count, 8);
    check(blobs.largest[0].pixels == FROB_IMAGE_SIDE * 3 / 2, "the joined one",
          blobs.largest[0].pixels, FROB_IMAGE_SIDE * 3 / 2);
    check(blobs.largest[1].pixels == 2 && blobs.largest[1].cx == 0, "the first tooth",
          blobs.largest[1].cx, 0);
    picture_free(image);
}

int main(void)
{
    colours_are_those_of_the_book();
    ends_of_ranges();
    random_images();
    discs();
    combs();
    printf("blobs: %d failures\n", failures());
    return failures() > 0;
}
