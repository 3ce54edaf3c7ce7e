/* template.c -- finds candidate positions of a patch in a region: correlates the patch with every
 * position, in an image reduced so that the patch is 7 or 8 cells wide. */
#include "clones.h"
#include "view.h"

#include <frob/elementary.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMNS = 160, ROWS = 120, REACH = 6, SIDE = FROB_PATCH_SIDE };

/* A region reduced to cells, each with its mean brightness. The sides of a cell are approximately
 * `size` pixels long. */
struct cells {
    double left, top, size;
    int32_t columns, rows;
    uint8_t means[ROWS][COLUMNS];
};

/* A cell of the template; its position is relative to the middle cell. */
struct part {
    int32_t column, row;
    int32_t value; /* brightness minus the mean, in units of 1/16 */
};

static void reduce(const struct frob_image *image, const struct frob_view *view, double size,
                   struct cells *cells)
{
    uint8_t room[FROB_IMAGE_SIDE];
    int32_t sums[COLUMNS];

    cells->left = view->left;
    cells->top = view->top;
    cells->size = size;
    cells->columns = (int32_t)((view->right - view->left) / size);
    cells->rows = (int32_t)((view->bottom - view->top) / size);
    cells->columns = cells->columns < COLUMNS ? cells->columns : COLUMNS;
    cells->rows = cells->rows < ROWS ? cells->rows : ROWS;
    for (int32_t j = 0; j < cells->rows; j++) {
        const int32_t top = (int32_t)(j * size), bottom = (int32_t)((j + 1) * size);
        memset(sums, 0, sizeof sums);
        for (int32_t y = top; y < bottom; y++) {
            const uint8_t *row = frob_grey_row(image, view->top + y, view->left, view->right, room);
            for (int32_t i = 0; i < cells->columns; i++)
                for (int32_t x = (int32_t)(i * size); x < (int32_t)((i + 1) * size); x++)
                    sums[i] += row[x];
        }
        for (int32_t i = 0; i < cells->columns; i++) {
            const int32_t width = (int32_t)((i + 1) * size) - (int32_t)(i * size);
            const int32_t count = width * (bottom - top);
            cells->means[j][i] = (uint8_t)((sums[i] + count / 2) / count);
        }
    }
}

/* Computes the mean of the samples around a position of the patch, over a square of `size` samples.
 * Returns false if the square is not within the patch. */
static bool mean_of(const double *patch, double u, double v, double size, double *mean)
{
    const double left = u - size / 2, top = v - size / 2;
    const double end = (double)SIDE - 0.49;
    const int32_t parts = 4;
    double sum = 0;

    if (!(left >= -0.51 && top >= -0.51 && left + size <= end && top + size <= end))
        return false;
    for (int32_t j = 0; j < parts; j++)
        for (int32_t i = 0; i < parts; i++) {
            const int32_t column = (int32_t)(left + (i + 0.5) * size / parts + 0.5);
            const int32_t row = (int32_t)(top + (j + 0.5) * size / parts + 0.5);
            sum +=
                patch[(row < SIDE ? row : SIDE - 1) * SIDE + (column < SIDE ? column : SIDE - 1)];
        }
    *mean = sum / (parts * parts);
    return true;
}

/* Computes the cells that the rotated patch covers completely, and the sum of their squared
 * values. */
static int32_t parts_of(const double *patch, const struct frob_placement *like, double size,
                        struct part *parts, double *power)
{
    const double cosine = frob_cos(like->angle) / like->scale * size;
    const double sine = frob_sin(like->angle) / like->scale * size;
    double values[(2 * REACH + 1) * (2 * REACH + 1)], sum = 0;
    int32_t count = 0;

    for (int32_t j = -REACH; j <= REACH; j++)
        for (int32_t i = -REACH; i <= REACH; i++) {
            const double u = (SIDE - 1) / 2.0 + i * cosine + j * sine;
            const double v = (SIDE - 1) / 2.0 + j * cosine - i * sine;
            if (!mean_of(patch, u, v, size / like->scale, &values[count]))
                continue;
            parts[count].column = i;
            parts[count].row = j;
            sum += values[count++];
        }
    *power = 0;
    for (int32_t i = 0; i < count; i++) {
        const double value = 16 * (values[i] - sum / count);
        if (!(value > -8192 && value < 8192))
            return 0;
        parts[i].value = (int32_t)(value + (value < 0 ? -0.5 : 0.5));
        *power += parts[i].value * (double)parts[i].value;
    }
    return count;
}

/* For each cell of a row, with the template centred on that cell: the sums of the brightness, of
 * its square, and of its product with the template. */
struct row_sums {
    int32_t sum[COLUMNS], squares[COLUMNS], products[COLUMNS];
};

static void add_part(const uint8_t *FROB_APART means, int32_t value, int32_t count,
                     int32_t *FROB_APART sum, int32_t *FROB_APART squares,
                     int32_t *FROB_APART products)
{
    for (int32_t i = 0; i < count; i++) {
        const int32_t mean = means[i];
        sum[i] += mean;
        squares[i] += mean * mean;
        products[i] += mean * value;
    }
}

static double larger(double a, double b)
{
    return a > b ? a : b;
}

void frob_find_template(const struct frob_image *image, const struct frob_region *roi,
                        const double patch[FROB_PATCH_SIZE], const struct frob_placement *like,
                        struct frob_match *result)
{
    const struct frob_view view = frob_view_of(image, roi);
    struct part parts[(2 * REACH + 1) * (2 * REACH + 1)];
    struct row_sums sums;
    struct cells cells;
    int32_t count, reach = 0;
    double size = 4 * like->scale, power, best = 0;

    result->place = *like;
    result->residual = 1;
    if (!(like->scale > 1e-3 && like->scale < 1e4 && like->angle > -1e6 && like->angle < 1e6) ||
        image->format == FROB_DEPTH_M || view.left == view.right)
        return;
    size = larger(larger(size, 1), larger((view.right - view.left) / (double)COLUMNS,
                                          (view.bottom - view.top) / (double)ROWS));
    count = parts_of(patch, like, size, parts, &power);
    reduce(image, &view, size, &cells);
    for (int32_t k = 0; k < count; k++) {
        const int32_t across = abs(parts[k].column), down = abs(parts[k].row);
        reach = across > reach ? across : reach;
        reach = down > reach ? down : reach;
    }
    if (!(power > 0))
        return;
    for (int32_t j = reach; j < cells.rows - reach; j++) {
        const int32_t across = cells.columns - 2 * reach;
        memset(&sums, 0, sizeof sums);
        for (int32_t k = 0; k < count && across > 0; k++)
            add_part(&cells.means[j + parts[k].row][reach + parts[k].column], parts[k].value,
                     across, sums.sum, sums.squares, sums.products);
        for (int32_t i = 0; i < across; i++) {
            const double other = sums.squares[i] - sums.sum[i] * (double)sums.sum[i] / count;
            const double both = sums.products[i];
            /* Compares squared correlations. Ignores positions whose contrast is at most one
             * brightness step. */
            if (both > 0 && other > count && both * both > best * power * other) {
                best = both * both / (power * other);
                result->place.x = cells.left + (reach + i + 0.5) * size - 0.5;
                result->place.y = cells.top + (j + 0.5) * size - 0.5;
                result->residual = best < 1 ? sqrt(1 - best) : 0;
            }
        }
    }
}
