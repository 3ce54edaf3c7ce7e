/* corner.c -- finds the strongest corner in a region: the position that least resembles a uniform
 * area or a straight edge.
 *
 * It keeps, for each column, sums of products of gradients over 5 rows, and updates them from row
 * to row. */
#include "view.h"

#include <math.h>
#include <string.h>

enum { AROUND = 2, SPAN = 2 * AROUND + 1 };

/* Sums of gx gx, gx gy and gy gy over 5 rows. The gradients are doubled; a sum over 5 by 5 pixels
 * is at most 25 * 255^2. */
struct sums {
    int32_t xx[FROB_IMAGE_SIDE], xy[FROB_IMAGE_SIDE], yy[FROB_IMAGE_SIDE];
};

struct greys {
    const uint8_t *rows[3];
    uint8_t rooms[3][FROB_IMAGE_SIDE];
};

/* Adds row y to the sums if `sign` is 1, or subtracts it if `sign` is -1. Its neighbouring rows
 * must be in the image. */
static void add_row(const struct frob_image *image, int32_t y, int32_t sign, struct sums *sums)
{
    struct greys greys;

    for (int32_t i = 0; i < 3; i++)
        greys.rows[i] = frob_grey_row(image, y - 1 + i, 0, image->width, greys.rooms[i]);
    for (int32_t x = 1; x < image->width - 1; x++) {
        const int32_t gx = greys.rows[1][x + 1] - greys.rows[1][x - 1];
        const int32_t gy = greys.rows[2][x] - greys.rows[0][x];
        sums->xx[x] += sign * gx * gx;
        sums->xy[x] += sign * gx * gy;
        sums->yy[x] += sign * gy * gy;
    }
}

/* Returns the smaller eigenvalue of the structure tensor. The arguments are sums of products of
 * doubled gradients over 25 pixels. */
static double score_of(double xx, double xy, double yy)
{
    const double half = (xx - yy) / 2;
    const double score = ((xx + yy) / 2 - sqrt(half * half + xy * xy)) / (4 * SPAN * SPAN);

    return score > 0 ? score : 0;
}

/* Computes the scores of the columns left … right - 1 of a row. */
static void scores_of(const struct sums *sums, int32_t left, int32_t right, double *scores)
{
    int32_t xx = 0, xy = 0, yy = 0;

    for (int32_t x = left - AROUND; x < left + AROUND; x++) {
        xx += sums->xx[x];
        xy += sums->xy[x];
        yy += sums->yy[x];
    }
    for (int32_t x = left; x < right; x++) {
        xx += sums->xx[x + AROUND];
        xy += sums->xy[x + AROUND];
        yy += sums->yy[x + AROUND];
        scores[x] = score_of(xx, xy, yy);
        xx -= sums->xx[x - AROUND];
        xy -= sums->xy[x - AROUND];
        yy -= sums->yy[x - AROUND];
    }
}

/* Refines a corner by the method of Foerstner and Guelch: each pixel defines a line along its edge,
 * and the result is the position closest to all these lines, by least squares of the distances,
 * weighted by the gradients. Uses the pixels around (x, y); all neighbours of these pixels must be
 * in the image. Returns false if the result is not near (x, y). */
static bool refine(const struct frob_image *image, int32_t x, int32_t y, struct frob_corner *corner)
{
    double xx = 0, xy = 0, yy = 0, toward_x = 0, toward_y = 0, toward, determinant;
    struct greys greys;

    for (int32_t j = -AROUND; j <= AROUND; j++) {
        for (int32_t i = 0; i < 3; i++)
            greys.rows[i] = frob_grey_row(image, y + j - 1 + i, 0, image->width, greys.rooms[i]);
        for (int32_t i = -AROUND; i <= AROUND; i++) {
            const double gx = greys.rows[1][x + i + 1] - greys.rows[1][x + i - 1];
            const double gy = greys.rows[2][x + i] - greys.rows[0][x + i];
            xx += gx * gx;
            xy += gx * gy;
            yy += gy * gy;
            toward_x += gx * (gx * i + gy * j);
            toward_y += gy * (gx * i + gy * j);
        }
    }
    determinant = xx * yy - xy * xy;
    if (!(determinant > 0))
        return false;
    toward = (toward_x * yy - toward_y * xy) / determinant;
    toward_y = (toward_y * xx - toward_x * xy) / determinant;
    if (!(fabs(toward) <= AROUND + 1 && fabs(toward_y) <= AROUND + 1))
        return false;
    corner->x = x + toward;
    corner->y = y + toward_y;
    return true;
}

void frob_find_corner(const struct frob_image *image, const struct frob_region *roi,
                      struct frob_corner *result)
{
    struct frob_view view = frob_view_of(image, roi);
    const int32_t margin = AROUND + 1;
    double scores[FROB_IMAGE_SIDE];
    struct sums sums;

    memset(result, 0, sizeof *result);
    if (!frob_image_is_sound(image) || image->format == FROB_DEPTH_M)
        return;
    view.left = view.left > margin ? view.left : margin;
    view.top = view.top > margin ? view.top : margin;
    view.right = view.right < image->width - margin ? view.right : image->width - margin;
    view.bottom = view.bottom < image->height - margin ? view.bottom : image->height - margin;
    if (view.left >= view.right || view.top >= view.bottom)
        return;
    memset(&sums, 0, sizeof sums);
    for (int32_t y = view.top - AROUND; y < view.top + AROUND; y++)
        add_row(image, y, 1, &sums);
    for (int32_t y = view.top; y < view.bottom; y++) {
        add_row(image, y + AROUND, 1, &sums);
        scores_of(&sums, view.left, view.right, scores);
        add_row(image, y - AROUND, -1, &sums);
        for (int32_t x = view.left; x < view.right; x++)
            if (scores[x] > result->score) {
                result->x = x;
                result->y = y;
                result->score = scores[x];
            }
    }
    /* Refines the position up to three times, each time with the window centred on the latest
     * result, so that it covers more of the corner. */
    for (int32_t i = 0; i < 3 && result->score > 0; i++) {
        const int32_t x = (int32_t)(result->x + 0.5), y = (int32_t)(result->y + 0.5);
        if (x < margin || y < margin || x >= image->width - margin || y >= image->height - margin ||
            !refine(image, x, y, result))
            return;
    }
}
