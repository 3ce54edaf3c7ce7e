#include "patch.h"

#include "view.h"

#include <frob/elementary.h>

#include <string.h>

enum { SIDE = FROB_PATCH_SIDE, ROOM_SIDE = 160 };

static const double middle = (SIDE - 1) / 2.0;

/* Returns whether the position of every sample can be rounded to an int32_t. The limits are far
 * outside any image. */
static bool is_place(const struct frob_placement *p)
{
    return p->x > -1e6 && p->x < 1e6 && p->y > -1e6 && p->y < 1e6 && p->angle > -1e6 &&
           p->angle < 1e6 && p->scale > 1e-3 && p->scale < 1e4;
}

/* Rounds x down and clamps it to 0 … most. */
static int32_t column_of(double x, int32_t most)
{
    return !(x > 0) ? 0 : x >= most ? most : (int32_t)x;
}

/* Computes the first column (or row) of the part to copy, and the number of its columns (or rows)
 * that fit in the buffer. If the whole part does not fit, chooses its middle, where the search for
 * the patch starts. */
static void take_part(double place, double around, int32_t size, int32_t *from, int32_t *count)
{
    const double most = ROOM_SIDE / 2 - 1, reach = around < most ? around : most;

    *from = column_of(place - reach, size - 1);
    *count = column_of(place + reach, size - 1) + 1 - *from;
}

bool frob_greys_around(struct frob_greys *greys, const struct frob_image *image,
                       const struct frob_placement *place, double reach)
{
    const double around = reach + 1.4143 * (middle + 1) * place->scale + 2;

    if (!frob_image_is_sound(image) || image->format == FROB_DEPTH_M || image->width == 0 ||
        image->height == 0 || !is_place(place))
        return false;
    greys->image = image;
    if (image->format == FROB_GREY8) {
        greys->left = greys->top = 0;
        greys->width = image->width;
        greys->height = image->height;
        greys->pixels = (const uint8_t *)image->pixels;
        greys->stride = image->stride;
        return true;
    }
    take_part(place->x, around, image->width, &greys->left, &greys->width);
    take_part(place->y, around, image->height, &greys->top, &greys->height);
    greys->pixels = greys->room;
    greys->stride = ROOM_SIDE;
    for (int32_t y = 0; y < greys->height; y++) {
        uint8_t *room = greys->room + y * ROOM_SIDE;
        (void)frob_grey_row(image, greys->top + y, greys->left, greys->left + greys->width, room);
    }
    return true;
}

/* The same as frob_grey_at, but skips its checks if all four pixels are in the buffer. */
static double grey_at(const struct frob_greys *g, double x, double y)
{
    const double column = x - g->left, row = y - g->top;

    if (column >= 0 && row >= 0 && column < g->width - 1 && row < g->height - 1) {
        const int32_t left = (int32_t)column, top = (int32_t)row;
        const double over = column - left, down = row - top;
        const uint8_t *upper = g->pixels + top * g->stride + left, *lower = upper + g->stride;
        const double above = upper[0] + over * (upper[1] - upper[0]);
        const double below = lower[0] + over * (lower[1] - lower[0]);
        return above + down * (below - above);
    }
    return frob_grey_at(g->image, x, y);
}

int32_t frob_cut_patch(const struct frob_greys *greys, const struct frob_placement *place,
                       double samples[FROB_PATCH_SIZE])
{
    const double cosine = place->scale * frob_cos(place->angle);
    const double sine = place->scale * frob_sin(place->angle);
    /* Each sample is the mean of `parts` by `parts` pixels. */
    const int32_t parts = place->scale > 3 ? 4 : place->scale > 2 ? 3 : place->scale > 1.25 ? 2 : 1;
    const double right = greys->image->width - 0.5, bottom = greys->image->height - 0.5;
    int32_t inside = 0;

    for (int32_t j = 0; j < SIDE; j++)
        for (int32_t i = 0; i < SIDE; i++) {
            const double u = i - middle, v = j - middle;
            const double x = place->x + u * cosine - v * sine;
            const double y = place->y + u * sine + v * cosine;
            double sum = 0;
            if (parts == 1) {
                sum = grey_at(greys, x, y);
            } else {
                for (int32_t n = 0; n < parts; n++)
                    for (int32_t m = 0; m < parts; m++) {
                        const double a = (m + 0.5) / parts - 0.5, b = (n + 0.5) / parts - 0.5;
                        sum += grey_at(greys, x + a * cosine - b * sine, y + a * sine + b * cosine);
                    }
                sum /= parts * parts;
            }
            samples[j * SIDE + i] = sum;
            inside += x >= -0.5 && x < right && y >= -0.5 && y < bottom;
        }
    return inside;
}

void frob_get_patch(const struct frob_image *image, const struct frob_placement *place,
                    double result[FROB_PATCH_SIZE])
{
    struct frob_greys greys;

    memset(result, 0, FROB_PATCH_SIZE * sizeof *result);
    if (frob_greys_around(&greys, image, place, 0))
        (void)frob_cut_patch(&greys, place, result);
}
