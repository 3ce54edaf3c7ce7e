#include "moments.h"

#include <frob/elementary.h>

#include <math.h>
#include <string.h>

struct frob_moments frob_no_moments(void)
{
    const struct frob_moments none = { 0, 0, 0, 0, 0, 0, INT32_MAX, INT32_MAX, -1, -1 };
    return none;
}

/* 0^2 + 1^2 + … + (n - 1)^2 */
static int64_t squares_below(int64_t n)
{
    return n * (n - 1) * (2 * n - 1) / 6;
}

void frob_add_run(struct frob_moments *moments, int32_t y, int32_t start, int32_t end)
{
    const int64_t n = end - start;
    const int64_t x = n * ((int64_t)start + end - 1) / 2;

    moments->count += n;
    moments->x += x;
    moments->y += n * y;
    moments->xx += squares_below(end) - squares_below(start);
    moments->xy += x * y;
    moments->yy += n * y * y;
    moments->left = start < moments->left ? start : moments->left;
    moments->top = y < moments->top ? y : moments->top;
    moments->right = end - 1 > moments->right ? end - 1 : moments->right;
    moments->bottom = y > moments->bottom ? y : moments->bottom;
}

void frob_add_moments(struct frob_moments *moments, const struct frob_moments *others)
{
    moments->count += others->count;
    moments->x += others->x;
    moments->y += others->y;
    moments->xx += others->xx;
    moments->xy += others->xy;
    moments->yy += others->yy;
    moments->left = others->left < moments->left ? others->left : moments->left;
    moments->top = others->top < moments->top ? others->top : moments->top;
    moments->right = others->right > moments->right ? others->right : moments->right;
    moments->bottom = others->bottom > moments->bottom ? others->bottom : moments->bottom;
}

/* Computes the ellipse with the same second moments: its axes have lengths 4 sqrt(eigenvalue). Each
 * pixel is a unit square, not a point, so 1/12 is added to the variances of x and y. */
void frob_blob_of(const struct frob_moments *moments, struct frob_blob *result)
{
    memset(result, 0, sizeof *result);
    if (moments->count == 0)
        return;
    {
        /* Moments relative to the corner of the bounding box are exact, and so small that
         * subtracting the squares loses little precision. */
        const int64_t left = moments->left, top = moments->top;
        const double n = (double)moments->count;
        const double x = (double)(moments->x - left * moments->count) / n;
        const double y = (double)(moments->y - top * moments->count) / n;
        const double xx =
            (double)(moments->xx - 2 * left * moments->x + left * left * moments->count) / n;
        const double xy = (double)(moments->xy - left * moments->y - top * moments->x +
                                   left * top * moments->count) /
                          n;
        const double yy =
            (double)(moments->yy - 2 * top * moments->y + top * top * moments->count) / n;
        const double a = xx - x * x + 1.0 / 12, b = xy - x * y, c = yy - y * y + 1.0 / 12;
        const double middle = (a + c) / 2, half = (a - c) / 2;
        const double apart = sqrt(half * half + b * b);

        result->pixels = (int32_t)moments->count;
        result->cx = (double)left + x;
        result->cy = (double)top + y;
        result->box.x = moments->left;
        result->box.y = moments->top;
        result->box.width = moments->right - moments->left + 1;
        result->box.height = moments->bottom - moments->top + 1;
        result->major = 4 * sqrt(middle + apart);
        result->minor = 4 * sqrt(middle > apart ? middle - apart : 0);
        result->rotation = apart > 0 ? frob_atan2(b, half) / 2 : 0;
    }
}
