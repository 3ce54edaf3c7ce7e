/* edge.c -- finds edges along a segment, like XVision's edge tracker.
 *
 * The brightness profile along the segment is smoothed and differentiated in one pass, by the
 * derivative of a Gaussian with a standard deviation of one pixel. A sharp edge then looks like
 * that Gaussian, whose logarithm is a parabola: three values determine its maximum with subpixel
 * precision. */
#include "view.h"

#include <frob/elementary.h>

#include <string.h>

enum { REACH = 3, HALF = 64, PLACES = 2 * (HALF + REACH + 1) + 1 };

/* j exp(-j^2 / 2) for j = 1, 2, 3, normalized so that a slope of 1 results in 1. */
static const double weights[REACH] = { 0.24302970, 0.10845335, 0.01335376 };

/* Computes the mean brightness across the segment, at distance `along` from its middle. Returns
 * false if part of it is outside the image. */
static bool seen(const struct frob_image *image, const struct frob_segment *s, double cosine,
                 double sine, int32_t across, double along, double *result)
{
    double sum = 0;

    for (int32_t i = 0; i < across; i++) {
        const double aside = i - (across - 1) / 2.0;
        const double x = s->x + along * cosine - aside * sine;
        const double y = s->y + along * sine + aside * cosine;
        if (!(x >= 0 && x <= image->width - 1 && y >= 0 && y <= image->height - 1))
            return false;
        sum += frob_grey_at(image, x, y);
    }
    *result = sum / across;
    return true;
}

/* Interpolates the position of the maximum near the middle one of three values; uses their
 * logarithms if all are above 0. */
static double top_of(double before, double at, double after)
{
    double bend, offset;

    if (before > 0 && after > 0) {
        before = frob_log(before);
        at = frob_log(at);
        after = frob_log(after);
    }
    bend = before - 2 * at + after;
    offset = bend < 0 ? (before - after) / (2 * bend) : 0;
    return offset < -0.5 ? -0.5 : offset > 0.5 ? 0.5 : offset;
}

/* Finds the maximum of sign * gradient among the positions -half … half, where 0 is the middle. */
static void strongest(const double *gradients, int32_t half, double sign, struct frob_edge *result)
{
    double best = 0;

    for (int32_t k = -half; k <= half; k++) {
        const double before = sign * gradients[k - 1], at = sign * gradients[k];
        const double after = sign * gradients[k + 1];
        if (at > best && at >= before && at >= after) {
            best = at;
            result->offset = k + top_of(before, at, after);
            result->gradient = sign * at;
        }
    }
}

void frob_find_edges(const struct frob_image *image, const struct frob_segment *s,
                     struct frob_edges *result)
{
    const double cosine = frob_cos(s->angle), sine = frob_sin(s->angle);
    const int32_t half = s->length >= 2 * HALF ? HALF
                         : s->length > 0       ? (int32_t)(s->length / 2)
                                               : 0;
    const int32_t across = s->width >= 32 ? 32 : s->width > 1 ? (int32_t)(s->width + 0.5) : 1;
    double profile[PLACES], gradients[PLACES];
    bool known[PLACES];
    const int32_t middle = HALF + REACH + 1;

    memset(result, 0, sizeof *result);
    if (!frob_image_is_sound(image) || image->format == FROB_DEPTH_M || image->width == 0 ||
        image->height == 0)
        return;
    for (int32_t k = -half - REACH - 1; k <= half + REACH + 1; k++)
        known[middle + k] = seen(image, s, cosine, sine, across, k, &profile[middle + k]);
    for (int32_t k = -half - 1; k <= half + 1; k++) {
        const int32_t at = middle + k;
        bool all = true;
        gradients[at] = 0;
        for (int32_t j = 1; j <= REACH; j++)
            all = all && known[at - j] && known[at + j];
        for (int32_t j = 1; j <= REACH && all; j++)
            gradients[at] += weights[j - 1] * (profile[at + j] - profile[at - j]);
    }
    strongest(gradients + middle, half, 1, &result->rising);
    strongest(gradients + middle, half, -1, &result->falling);
}
