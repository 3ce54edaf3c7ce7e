/* depths.c -- computes depths from the images of two cameras. */
#include "stereo.h"

#include <math.h>
#include <string.h>

enum { WIDTH = 640, DISPARITIES = 64, WINDOW = 21, COLUMNS = 16, STEPS = 16 * DISPARITIES };

/* The number of pixels for each disparity. A disparity is in units of 1/16 pixel. */
struct counts {
    int32_t of[STEPS];
    int32_t known, all;
};

/* Returns the largest disparity such that at least `least` pixels have it or a larger one; -1 if
 * there are fewer pixels. */
static int32_t reached(const struct counts *counts, int32_t least)
{
    int32_t so_far = 0;

    for (int32_t d = STEPS - 1; d >= 0; d--) {
        so_far += counts->of[d];
        if (so_far >= least && so_far > 0)
            return d;
    }
    return -1;
}

static double depth_of(const struct frob_image *left, const struct frob_image *right,
                       int32_t disparity)
{
    const double x = left->camera.x_m - right->camera.x_m;
    const double y = left->camera.y_m - right->camera.y_m;
    const double z = left->camera.z_m - right->camera.z_m;
    const double scaled = sqrt(x * x + y * y + z * z) * left->camera.focal_x;
    const double pixels = disparity / 16.0 - (left->camera.centre_x - right->camera.centre_x);

    if (disparity < 0 || !(scaled > 0))
        return NAN;
    return pixels > 0 ? scaled / pixels : INFINITY;
}

static int32_t enough(const struct counts *counts)
{
    return counts->all / 20 > 8 ? counts->all / 20 : 8;
}

void frob_stereo_depths(const struct frob_image *left, const struct frob_image *right,
                        const struct frob_stereo *how, struct frob_depths *result)
{
    uint16_t room[FROB_STEREO_ROOM(WIDTH, DISPARITIES, WINDOW)];
    struct frob_view view = frob_view_of(left, &how->roi);
    struct frob_stereo cut = *how;
    struct frob_stereo_rows rows;
    struct counts columns[COLUMNS], total;
    int16_t disparities[WIDTH];

    memset(result, 0, sizeof *result);
    memset(columns, 0, sizeof columns);
    memset(&total, 0, sizeof total);
    if (view.right - view.left > WIDTH) {
        view.left += (view.right - view.left - WIDTH) / 2;
        view.right = view.left + WIDTH;
    }
    cut.roi.x = view.left;
    cut.roi.width = view.right - view.left;
    cut.disparities = how->disparities < DISPARITIES ? how->disparities : DISPARITIES;
    if (frob_stereo_begin(&rows, left, right, &cut, room, sizeof room))
        for (int32_t y = rows.view.top; y < rows.view.bottom; y++) {
            frob_stereo_row(&rows, y, disparities);
            for (int32_t i = 0; i < rows.width; i++) {
                struct counts *column = &columns[i * COLUMNS / rows.width];
                column->all++;
                column->known += disparities[i] >= 0;
                if (disparities[i] >= 0)
                    column->of[disparities[i]]++;
            }
        }
    for (int32_t k = 0; k < COLUMNS; k++) {
        result->columns[k] = depth_of(left, right, reached(&columns[k], enough(&columns[k])));
        total.all += columns[k].all;
        total.known += columns[k].known;
        for (int32_t d = 0; d < STEPS; d++)
            total.of[d] += columns[k].of[d];
    }
    result->known = total.all > 0 ? total.known / (double)total.all : 0;
    result->nearest = depth_of(left, right, reached(&total, enough(&total)));
    result->median = depth_of(
        left, right, total.known >= enough(&total) ? reached(&total, (total.known + 1) / 2) : -1);
}
