#include "stereo.h"

#include "clones.h"

#include <string.h>

enum {
    CUT = 31,
    LIKE = 10 /* percent */,
    TEXTURE = 10 /* minimum mean gradient, in units of 1/16 */
};

static int32_t limited(int32_t least, int32_t x, int32_t most)
{
    return x < least ? least : x > most ? most : x;
}

static int32_t disparities_of(const struct frob_stereo *how)
{
    return (limited(16, how->disparities, 256) + 8) / 16 * 16;
}

static int32_t around_of(const struct frob_stereo *how)
{
    return limited(5, how->window, 21) / 2;
}

size_t frob_stereo_room(int32_t width, const struct frob_stereo *how)
{
    const size_t window = 2 * (size_t)around_of(how) + 1;

    return width < 0 ? 0 : sizeof(uint16_t) * FROB_STEREO_ROOM(width, disparities_of(how), window);
}

/* ---- Rows */

/* Computes Sobel's horizontal gradient from three rows of brightness, clipped to -CUT … CUT and
 * shifted to start at 0. */
FROB_CLONES
static void changes_of(const uint8_t *FROB_APART above, const uint8_t *FROB_APART row,
                       const uint8_t *FROB_APART below, int32_t count, uint8_t *FROB_APART changes)
{
    const int16_t least = -CUT, most = CUT;

    for (int32_t i = 1; i < count - 1; i++) {
        const int16_t change =
            (int16_t)(above[i + 1] - above[i - 1] + 2 * (row[i + 1] - row[i - 1]) + below[i + 1] -
                      below[i - 1]);
        const int16_t cut = change < least ? least : change > most ? most : change;
        changes[i] = (uint8_t)(cut + CUT);
    }
    changes[0] = changes[count - 1] = CUT;
}

/* Computes the gradients of the columns first … first + count - 1 of a row. Columns outside the
 * image have the gradient at its border. */
static void change_row(const struct frob_image *image, int32_t y, int32_t first, int32_t count,
                       uint8_t *changes)
{
    uint8_t rooms[3][FROB_IMAGE_SIDE], all[FROB_IMAGE_SIDE];
    const uint8_t *rows[3];

    for (int32_t i = 0; i < 3; i++)
        rows[i] = frob_grey_row(image, limited(0, y - 1 + i, image->height - 1), 0, image->width,
                                rooms[i]);
    changes_of(rows[0], rows[1], rows[2], image->width, all);
    for (int32_t i = 0; i < count && first + i < 0; i++)
        changes[i] = all[0];
    {
        const int32_t from = limited(0, first, image->width);
        const int32_t to = limited(0, first + count, image->width);
        if (from < to)
            memcpy(changes + (from - first), all + from, (size_t)(to - from));
        for (int32_t i = to - first > 0 ? to - first : 0; i < count; i++)
            changes[i] = all[image->width - 1];
    }
}

FROB_CLONES
static void add_differences(const uint8_t *FROB_APART left, const uint8_t *FROB_APART right,
                            int32_t count, uint16_t *FROB_APART sums)
{
    for (int32_t i = 0; i < count; i++) {
        const uint8_t a = left[i], b = right[i];
        sums[i] = (uint16_t)(sums[i] + (uint8_t)(a > b ? a - b : b - a));
    }
}

FROB_CLONES
static void take_differences(const uint8_t *FROB_APART left, const uint8_t *FROB_APART right,
                             int32_t count, uint16_t *FROB_APART sums)
{
    for (int32_t i = 0; i < count; i++) {
        const uint8_t a = left[i], b = right[i];
        sums[i] = (uint16_t)(sums[i] - (uint8_t)(a > b ? a - b : b - a));
    }
}

/* Adds a row of both images to the column sums or, if `take` is true, subtracts it. */
static void add_row(struct frob_stereo_rows *rows, int32_t y, bool take)
{
    enum { WIDE = FROB_IMAGE_SIDE + 32 };
    const int32_t first = rows->view.left - rows->around, count = rows->wide;
    uint8_t left[WIDE], right[WIDE + 256];
    const int32_t back = rows->disparities - 1;
    const int32_t row = limited(0, y, rows->left->height - 1);

    change_row(rows->left, row, first, count, left);
    change_row(rows->right, row, first - back, count + back, right);
    for (int32_t d = 0; d < rows->disparities; d++) {
        uint16_t *sums = rows->columns + (ptrdiff_t)d * count;
        if (take)
            take_differences(left, right + back - d, count, sums);
        else
            add_differences(left, right + back - d, count, sums);
    }
    for (int32_t i = 0; i < count; i++) {
        const int32_t change = left[i] > CUT ? left[i] - CUT : CUT - left[i];
        rows->texture[i] += take ? -change : change;
    }
}

FROB_CLONES
static void add_doubles(const uint16_t *FROB_APART from, int32_t step, int32_t count,
                        uint16_t *FROB_APART to)
{
    for (int32_t i = 0; i < count; i++)
        to[i] = (uint16_t)(from[i] + from[i + step]);
}

FROB_CLONES
static void add_to(const uint16_t *FROB_APART from, int32_t count, uint16_t *FROB_APART to)
{
    for (int32_t i = 0; i < count; i++)
        to[i] = (uint16_t)(to[i] + from[i]);
}

/* For each position, adds up the `window` values that start there, using sums of 1, 2, 4, 8 and 16
 * neighbours. */
static void sum_windows(const uint16_t *columns, int32_t window, int32_t wide, uint16_t *sums)
{
    enum { WIDE = FROB_IMAGE_SIDE + 32 };
    uint16_t parts[2][WIDE];
    const int32_t count = wide - window + 1;
    const uint16_t *part = columns;
    int32_t done = 0;

    /* `part` contains sums of `size` neighbours; `sums` contains, for each window, the sum of its
     * first `done` values. */
    for (int32_t size = 1; size <= window; size *= 2) {
        if ((window & size) != 0) {
            if (done == 0)
                memcpy(sums, part, (size_t)count * sizeof *sums);
            else
                add_to(part + done, count, sums);
            done += size;
        }
        if (2 * size <= window) {
            uint16_t *next = parts[part == parts[0] ? 1 : 0];
            add_doubles(part, size, wide - 2 * size + 1, next);
            part = next;
        }
    }
}

/* ---- The best disparity */

FROB_CLONES
static void take_better(const uint16_t *FROB_APART sums, uint16_t disparity, int32_t count,
                        uint16_t *FROB_APART best, uint16_t *FROB_APART disparities)
{
    for (int32_t i = 0; i < count; i++) {
        const uint16_t sum = sums[i], before = best[i];
        disparities[i] = sum < before ? disparity : disparities[i];
        best[i] = sum < before ? sum : before;
    }
}

/* Marks columns where another disparity, not next to the best one, matches nearly as well. */
FROB_CLONES
static void find_rivals(const uint16_t *FROB_APART sums, uint16_t disparity, int32_t count,
                        const uint16_t *FROB_APART limits, const uint16_t *FROB_APART disparities,
                        uint16_t *FROB_APART rivals)
{
    for (int32_t i = 0; i < count; i++) {
        const uint16_t apart = (uint16_t)(disparities[i] - disparity + 1);
        rivals[i] = (uint16_t)(rivals[i] | ((sums[i] <= limits[i]) & (apart > 2)));
    }
}

/* Interpolates the position of the minimum, in units of 1/16, from three sums of which the middle
 * one is the smallest. Fits two lines of opposite slope, because sums of absolute
 * differences have a sharp minimum, not a rounded one. */
static int32_t beside(int32_t before, int32_t at, int32_t after)
{
    const int32_t slope = before > after ? before - at : after - at;
    const int32_t part = slope > 0 ? 8 * (before - after) : 0;

    return part == 0 ? 0 : part > 0 ? (part + slope / 2) / slope : -((-part + slope / 2) / slope);
}

static void find_best(const struct frob_stereo_rows *rows, int16_t *result)
{
    const int32_t count = rows->width, all = rows->disparities, window = 2 * rows->around + 1;
    uint16_t best[FROB_IMAGE_SIDE], found[FROB_IMAGE_SIDE];
    uint16_t from_right[FROB_IMAGE_SIDE], found_right[FROB_IMAGE_SIDE];
    uint16_t limits[FROB_IMAGE_SIDE], rivals[FROB_IMAGE_SIDE];
    int32_t texture = 0;

    memset(best, 0xff, (size_t)count * sizeof *best);
    memset(from_right, 0xff, (size_t)count * sizeof *from_right);
    memset(found, 0, (size_t)count * sizeof *found);
    memset(found_right, 0, (size_t)count * sizeof *found_right);
    memset(rivals, 0, (size_t)count * sizeof *rivals);
    for (int32_t d = 0; d < all; d++) {
        const uint16_t *sums = rows->squares + (ptrdiff_t)d * rows->wide;
        take_better(sums, (uint16_t)d, count, best, found);
        if (d < count)
            take_better(sums + d, (uint16_t)d, count - d, from_right, found_right);
    }
    for (int32_t i = 0; i < count; i++)
        limits[i] = (uint16_t)limited(0, best[i] + best[i] * LIKE / 100, UINT16_MAX);
    for (int32_t d = 0; d < all; d++)
        find_rivals(rows->squares + (ptrdiff_t)d * rows->wide, (uint16_t)d, count, limits, found,
                    rivals);
    for (int32_t i = 0; i < window - 1; i++)
        texture += rows->texture[i];
    for (int32_t i = 0; i < count; i++) {
        const int32_t d = found[i], other = i - d >= 0 ? found_right[i - d] : d;
        const uint16_t *sums = rows->squares + (ptrdiff_t)d * rows->wide + i;
        texture += rows->texture[i + window - 1];
        result[i] = -1;
        if (rivals[i] == 0 && rows->view.left + i >= d && d - other <= 1 && other - d <= 1 &&
            16 * texture > TEXTURE * window * window) {
            result[i] = (int16_t)(16 * d);
            if (d > 0 && d < all - 1)
                result[i] = (int16_t)(16 * d + beside(sums[-rows->wide], *sums, sums[rows->wide]));
        }
        texture -= rows->texture[i];
    }
}

/* ---- All rows */

bool frob_stereo_begin(struct frob_stereo_rows *rows, const struct frob_image *left,
                       const struct frob_image *right, const struct frob_stereo *how,
                       uint16_t *room, size_t room_size)
{
    const struct frob_view view = frob_view_of(left, &how->roi);
    size_t one;

    if (!frob_image_is_sound(right) || left->format == FROB_DEPTH_M ||
        right->format == FROB_DEPTH_M || left->width != right->width ||
        left->height != right->height || view.left == view.right)
        return false;
    rows->left = left;
    rows->right = right;
    rows->view = view;
    rows->width = view.right - view.left;
    rows->disparities = disparities_of(how);
    rows->around = around_of(how);
    rows->wide = rows->width + 2 * rows->around;
    one = (size_t)rows->wide * (size_t)rows->disparities;
    if (room_size < 2 * one * sizeof *room)
        return false;
    rows->columns = room;
    rows->squares = room + one;
    memset(rows->texture, 0, sizeof rows->texture);
    memset(rows->columns, 0, one * sizeof *rows->columns);
    for (int32_t y = view.top - rows->around; y < view.top + rows->around; y++)
        add_row(rows, y, false);
    return true;
}

void frob_stereo_row(struct frob_stereo_rows *rows, int32_t y, int16_t *disparities)
{
    add_row(rows, y + rows->around, false);
    for (int32_t d = 0; d < rows->disparities; d++)
        sum_windows(rows->columns + (ptrdiff_t)d * rows->wide, 2 * rows->around + 1, rows->wide,
                    rows->squares + (ptrdiff_t)d * rows->wide);
    find_best(rows, disparities);
    add_row(rows, y - rows->around, true);
}

bool frob_match_stereo(const struct frob_image *left, const struct frob_image *right,
                       const struct frob_stereo *how, uint16_t *room, size_t room_size,
                       int16_t *result, int32_t stride)
{
    struct frob_stereo_rows rows;

    if (!frob_stereo_begin(&rows, left, right, how, room, room_size))
        return false;
    for (int32_t y = rows.view.top; y < rows.view.bottom; y++)
        frob_stereo_row(&rows, y, result + (ptrdiff_t)(y - rows.view.top) * stride);
    return true;
}
