/* Tests patches. They must be cut as a slow version cuts them; be found where they were drawn, in
 * different light, with noise, rotated, and scaled; and be found again anywhere in the image. */
#include "picture.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 100, WAVES = 6, PATCH = FROB_PATCH_SIDE };

static const double degree = 0.017453292519943295;

/* A texture with its own coordinates, seen through a placement, in its own light. */
struct scene {
    double x, y, angle, scale, gain, bias, noise;
    double along[WAVES], down[WAVES], phases[WAVES];
};

static double texture(const struct scene *s, double u, double v)
{
    double sum = 0;

    for (int k = 0; k < WAVES; k++)
        sum += sin(s->along[k] * u + s->down[k] * v + s->phases[k]);
    return 128 + 28 * sum;
}

static double scene_shade(const void *scene, double x, double y)
{
    const struct scene *s = (const struct scene *)scene;
    const double c = cos(s->angle) / s->scale, n = sin(s->angle) / s->scale;
    const double u = (x - s->x) * c + (y - s->y) * n, v = (y - s->y) * c - (x - s->x) * n;
    const double value = s->gain * texture(s, u, v) + s->bias;
    return value < 0 ? 0 : value > 255 ? 255 : value;
}

static struct frob_image *drawn(const struct scene *s)
{
    struct frob_image *image = picture(SIDE, SIDE, FROB_GREY8);
    uint8_t *pixels = (uint8_t *)(uintptr_t)image->pixels;

    draw(image, 3, scene_shade, s);
    for (int i = 0; i < SIDE * SIDE && s->noise > 0; i++) {
        const double value = pixels[i] + s->noise * (random_share() + random_share() - 1);
        pixels[i] = (uint8_t)(value < 0 ? 0 : value > 255 ? 255 : value);
    }
    return image;
}

static struct scene random_scene(void)
{
    struct scene s = { SIDE / 2, SIDE / 2, 0, 1, 1, 0, 0, { 0 }, { 0 }, { 0 } };

    for (int k = 0; k < WAVES; k++) {
        s.along[k] = (0.1 + 0.08 * k) * cos(2.4 * k);
        s.down[k] = (0.1 + 0.08 * k) * sin(2.4 * k);
        s.phases[k] = 7 * random_share();
    }
    return s;
}

/* ---- Cutting */

static double grey(const struct frob_image *image, double x, double y)
{
    const int32_t column = (int32_t)fmin(fmax(x, 0), image->width - 1);
    const int32_t row = (int32_t)fmin(fmax(y, 0), image->height - 1);
    const uint8_t *p = frob_image_row(image, row) + column * frob_image_pixel_size(image->format);
    return image->format == FROB_RGB8 ? floor((77 * p[0] + 150 * p[1] + 29 * p[2]) / 256.0 + 0.5)
                                      : p[0];
}

static double between(const struct frob_image *image, double x, double y)
{
    const double left = floor(x), top = floor(y), a = x - left, b = y - top;
    return (1 - a) * (1 - b) * grey(image, left, top) + a * (1 - b) * grey(image, left + 1, top) +
           (1 - a) * b * grey(image, left, top + 1) + a * b * grey(image, left + 1, top + 1);
}

static void cut_as_by_the_formula(void)
{
    for (int k = 0; k < 300; k++) {
        struct frob_image *image = random_picture(64);
        const struct frob_placement p = { 64 * random_share(), 64 * random_share(),
                                          6.28 * random_share(), 0.2 + 5 * random_share() };
        const int parts = p.scale > 3 ? 4 : p.scale > 2 ? 3 : p.scale > 1.25 ? 2 : 1;
        double samples[FROB_PATCH_SIZE], worst = 0;
        frob_get_patch(image, &p, samples);
        for (int j = 0; j < PATCH; j++)
            for (int i = 0; i < PATCH; i++) {
                double sum = 0;
                for (int m = 0; m < parts; m++)
                    for (int n = 0; n < parts; n++) {
                        const double u = p.scale * (i - 15.5 + (m + 0.5) / parts - 0.5);
                        const double v = p.scale * (j - 15.5 + (n + 0.5) / parts - 0.5);
                        if (image->format != FROB_DEPTH_M && image->width > 0 && image->height > 0)
                            sum += between(image, p.x + u * cos(p.angle) - v * sin(p.angle),
                                           p.y + u * sin(p.angle) + v * cos(p.angle)) /
                                   (parts * parts);
                    }
                worst = fmax(worst, fabs(sum - samples[j * PATCH + i]));
            }
        check(worst < 1e-6, "a patch", worst, 0);
        picture_free(image);
    }
}

/* ---- Matching */

/* The residual sqrt(1 - r^2), with r the correlation, computed from samples. */
static double residual_at(const struct frob_image *image, const double *patch,
                          const struct frob_placement *place)
{
    double samples[FROB_PATCH_SIZE], a = 0, b = 0, aa = 0, bb = 0, ab = 0;
    const double n = FROB_PATCH_SIZE;

    frob_get_patch(image, place, samples);
    for (int i = 0; i < FROB_PATCH_SIZE; i++) {
        a += patch[i] / n;
        b += samples[i] / n;
    }
    for (int i = 0; i < FROB_PATCH_SIZE; i++) {
        aa += (patch[i] - a) * (patch[i] - a);
        bb += (samples[i] - b) * (samples[i] - b);
        ab += (patch[i] - a) * (samples[i] - b);
    }
    return sqrt(fmax(0, 1 - ab * ab / (aa * bb)));
}

struct errors {
    double place, angle, scale, residual; /* the largest */
    double squares;                       /* the sum for the positions */
};

/* Computes the errors over many scenes. In each it cuts a patch from one image and finds it in
 * another one, where its placement is up to `far` pixels, `turned` and `grown` away from the
 * start of the search. */
static struct errors errors_of(int scenes, int32_t freedom, double far, double turned, double grown,
                               double noise)
{
    struct errors worst = { 0, 0, 0, 0, 0 };

    for (int k = 0; k < scenes; k++) {
        struct scene s = random_scene();
        const struct frob_placement first = { s.x, s.y, 0, 1 };
        struct frob_image *before = drawn(&s), *after;
        struct frob_search search = { first, 2, 10, 0 };
        struct frob_match match;
        double patch[FROB_PATCH_SIZE];
        search.freedom = freedom;
        s.x += far * (2 * random_share() - 1);
        s.y += far * (2 * random_share() - 1);
        s.angle = turned * (2 * random_share() - 1);
        s.scale = 1 + grown * (2 * random_share() - 1);
        s.gain = 0.6 + 0.3 * random_share();
        s.bias = 20 * random_share();
        s.noise = noise;
        after = drawn(&s);
        frob_get_patch(before, &first, patch);
        frob_match_patch(after, patch, &search, &match);
        worst.place = fmax(worst.place, hypot(match.place.x - s.x, match.place.y - s.y));
        worst.squares += pow(hypot(match.place.x - s.x, match.place.y - s.y), 2) / scenes;
        worst.angle = fmax(worst.angle, fabs(match.place.angle - s.angle));
        worst.scale = fmax(worst.scale, fabs(match.place.scale / s.scale - 1));
        worst.residual = fmax(worst.residual, match.residual);
        check(fabs(residual_at(after, patch, &match.place) - match.residual) < 1e-6,
              "the residual is that of the place", match.residual, 0);
        /* No placement one step away is better, except for errors of interpolation. */
        for (int i = 0; i < 8; i++) {
            struct frob_placement near = match.place;
            const double sign = i % 2 ? 1 : -1;
            near.x += i / 2 == 0 ? 0.3 * sign : 0;
            near.y += i / 2 == 1 ? 0.3 * sign : 0;
            near.angle += i / 2 == 2 && freedom > 2 ? 0.03 * sign : 0;
            near.scale *= i / 2 == 3 && freedom > 3 ? 1 + 0.03 * sign : 1;
            check(residual_at(after, patch, &near) >= match.residual, "the best near by",
                  residual_at(after, patch, &near), match.residual);
        }
        picture_free(before);
        picture_free(after);
    }
    return worst;
}

static void found_where_they_were_drawn(void)
{
    const struct errors shift = errors_of(20, 2, 5, 0, 0, 0);
    const struct errors turn = errors_of(20, 3, 4, 15 * degree, 0, 0);
    const struct errors all = errors_of(20, 4, 4, 12 * degree, 0.12, 0);
    const struct errors noisy = errors_of(20, 4, 4, 12 * degree, 0.12, 12);

    check(shift.place < 0.03, "shifted, px", shift.place, 0);
    check(turn.place < 0.05, "turned, px", turn.place, 0);
    check(turn.angle < 0.1 * degree, "angle", turn.angle, 0);
    check(all.place < 0.05, "grown, px", all.place, 0);
    check(all.scale < 0.005, "scale", all.scale, 0);
    check(sqrt(noisy.squares) < 0.1, "with noise, px (RMS)", sqrt(noisy.squares), 0);
    check(all.residual < 0.1, "residual", all.residual, 0);
    printf("places to %.3f px; %.3f px turned; %.3f px grown; RMS %.3f px with noise\n",
           shift.place, turn.place, all.place, sqrt(noisy.squares));
}

static void what_is_not_there(void)
{
    struct scene one = random_scene(), other = random_scene();
    const struct frob_placement first = { one.x, one.y, 0, 1 }, outside = { -200, 5, 0, 1 };
    struct frob_search search = { first, 2, 10, 4 };
    struct frob_image *image = drawn(&one), *another = drawn(&other);
    double patch[FROB_PATCH_SIZE];
    struct frob_match match;

    frob_get_patch(image, &first, patch);
    frob_match_patch(another, patch, &search, &match);
    check(match.residual > 0.6, "another picture", match.residual, 1);
    search.from = outside;
    frob_match_patch(image, patch, &search, &match);
    check(match.residual == 1, "outside", match.residual, 1);
    memset((void *)(uintptr_t)another->pixels, 77, SIDE * SIDE);
    search.from = first;
    frob_match_patch(another, patch, &search, &match);
    check(match.residual == 1, "a blank wall", match.residual, 1);
    frob_get_patch(another, &first, patch);
    frob_match_patch(image, patch, &search, &match);
    check(match.residual == 1, "a blank patch", match.residual, 1);
    picture_free(image);
    picture_free(another);
}

/* ---- Finding a lost patch */

static void found_again_anywhere(void)
{
    int right = 0;

    for (int k = 0; k < 40; k++) {
        struct scene s = random_scene();
        const struct frob_placement first = { s.x, s.y, 0, 1 };
        struct frob_placement like = { 0, 0, (k % 4) * 0.4, 1 };
        struct frob_image *before = drawn(&s), *after;
        struct frob_search search = { first, 2, 10, 4 };
        struct frob_match rough, fine;
        double patch[FROB_PATCH_SIZE];
        frob_get_patch(before, &first, patch);
        s.x = 30 + 40 * random_share();
        s.y = 30 + 40 * random_share();
        s.angle = like.angle + 0.1 * (random_share() - 0.5);
        s.gain = 0.8;
        s.noise = 10;
        after = drawn(&s);
        frob_find_template(after, &everywhere, patch, &like, &rough);
        search.from = rough.place;
        frob_match_patch(after, patch, &search, &fine);
        right += hypot(fine.place.x - s.x, fine.place.y - s.y) < 0.3 && fine.residual < 0.4;
        picture_free(before);
        picture_free(after);
    }
    check(right >= 38, "found again, of 40", right, 40);
}

int main(void)
{
    cut_as_by_the_formula();
    found_where_they_were_drawn();
    what_is_not_there();
    found_again_anywhere();
    printf("patches: %d failures\n", failures());
    return failures() > 0;
}
