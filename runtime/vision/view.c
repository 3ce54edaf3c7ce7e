#include "view.h"

#include "clones.h"

/* Rounds x up and clamps it to 0 … most; returns `most` if x is NaN. */
static int32_t first_from(double x, int32_t most)
{
    int32_t k;

    if (!(x < most))
        return most;
    if (!(x > 0))
        return 0;
    k = (int32_t)x;
    return k < x ? k + 1 : k;
}

struct frob_view frob_view_of(const struct frob_image *image, const struct frob_region *roi)
{
    const struct frob_view nothing = { 0, 0, 0, 0 };
    const double right = roi->x + roi->width, bottom = roi->y + roi->height;
    struct frob_view view;

    if (!frob_image_is_sound(image) || !(right > roi->x) || !(bottom > roi->y))
        return nothing;
    view.left = first_from(roi->x, image->width);
    view.top = first_from(roi->y, image->height);
    view.right = first_from(right, image->width);
    view.bottom = first_from(bottom, image->height);
    return view.left < view.right && view.top < view.bottom ? view : nothing;
}

static uint8_t grey_of(const uint8_t *colour)
{
    return (uint8_t)((77 * colour[0] + 150 * colour[1] + 29 * colour[2] + 128) >> 8);
}

FROB_CLONES
static void grey_of_row(const uint8_t *FROB_APART colours, int32_t count, uint8_t *FROB_APART greys)
{
    for (int32_t i = 0; i < count; i++)
        greys[i] = grey_of(colours + 3 * i);
}

const uint8_t *frob_grey_row(const struct frob_image *image, int32_t y, int32_t left, int32_t right,
                             uint8_t *room)
{
    const uint8_t *row = frob_image_row(image, y);

    if (image->format != FROB_RGB8)
        return row + left;
    grey_of_row(row + 3 * (ptrdiff_t)left, right - left, room);
    return room;
}

static double limited(double x, double most)
{
    return !(x > 0) ? 0 : x > most ? most : x;
}

double frob_grey_at(const struct frob_image *image, double x, double y)
{
    const double column = limited(x, image->width - 1), row = limited(y, image->height - 1);
    const int32_t left = (int32_t)column, top = (int32_t)row;
    const int32_t right = left + 1 < image->width ? 1 : 0;
    const int32_t below = top + 1 < image->height ? 1 : 0;
    const double over = column - left, down = row - top;
    const uint8_t *upper = frob_image_row(image, top), *lower = frob_image_row(image, top + below);
    double a, b, c, d;

    if (image->format == FROB_RGB8) {
        a = grey_of(upper + 3 * (ptrdiff_t)left);
        b = grey_of(upper + 3 * (ptrdiff_t)(left + right));
        c = grey_of(lower + 3 * (ptrdiff_t)left);
        d = grey_of(lower + 3 * (ptrdiff_t)(left + right));
    } else {
        a = upper[left];
        b = upper[left + right];
        c = lower[left];
        d = lower[left + right];
    }
    a += over * (b - a);
    c += over * (d - c);
    return a + down * (c - a);
}
