/* statistics.c -- statistics of brightness and depth in a region. */
#include "view.h"

#include <math.h>
#include <string.h>

/* Counts the pixels with each brightness. */
static void count(const struct frob_image *image, const struct frob_view *view, int32_t counts[256])
{
    uint8_t room[FROB_IMAGE_SIDE];

    memset(counts, 0, 256 * sizeof *counts);
    for (int32_t y = view->top; y < view->bottom; y++) {
        const uint8_t *row = frob_grey_row(image, y, view->left, view->right, room);
        for (int32_t i = 0; i < view->right - view->left; i++)
            counts[row[i]]++;
    }
}

/* Returns the k-th smallest brightness; k starts at 0. */
static double grey_with(const int32_t counts[256], int64_t k)
{
    int32_t value = 0;

    while (value < 255 && k >= counts[value])
        k -= counts[value++];
    return value;
}

static void of_greys(const int32_t counts[256], struct frob_statistics *result)
{
    int64_t n = 0, sum = 0, squares = 0;

    for (int32_t i = 0; i < 256; i++) {
        n += counts[i];
        sum += (int64_t)i * counts[i];
        squares += (int64_t)i * i * counts[i];
    }
    if (n == 0)
        return;
    {
        const double mean = (double)sum / (double)n;
        const double variance = (double)squares / (double)n - mean * mean;
        result->pixels = (int32_t)n;
        result->mean = mean;
        result->stdev = sqrt(variance > 0 ? variance : 0);
        result->min = grey_with(counts, 0);
        result->lq = grey_with(counts, (n - 1) / 4);
        result->median = grey_with(counts, (n - 1) / 2);
        result->uq = grey_with(counts, (3 * n - 1) / 4);
        result->max = grey_with(counts, n - 1);
    }
}

/* ---- Depths
 *
 * Positive floats have the same order as their bits. */

static uint32_t bits_of(const uint8_t *row, int32_t x)
{
    uint32_t bits;

    memcpy(&bits, row + sizeof bits * (size_t)x, sizeof bits);
    return bits;
}

static double depth_of(uint32_t bits)
{
    float depth;

    memcpy(&depth, &bits, sizeof depth);
    return (double)depth;
}

static bool is_known(uint32_t bits)
{
    return bits > 0 && bits < UINT32_C(0x7f800000);
}

/* Returns the k-th smallest depth (k starts at 0) by radix selection: each pass over the pixels
 * determines eight more bits. */
static double depth_with(const struct frob_image *image, const struct frob_view *view, int64_t k)
{
    uint32_t found = 0;

    for (uint32_t shift = 32; shift > 0;) {
        const uint32_t above = shift;
        int32_t counts[256];
        shift -= 8;
        memset(counts, 0, sizeof counts);
        for (int32_t y = view->top; y < view->bottom; y++) {
            const uint8_t *row = frob_image_row(image, y);
            for (int32_t x = view->left; x < view->right; x++) {
                const uint32_t bits = bits_of(row, x);
                if (is_known(bits) && (above == 32 || bits >> above == found >> above))
                    counts[bits >> shift & 255]++;
            }
        }
        {
            uint32_t value = 0;
            while (value < 255 && k >= counts[value])
                k -= counts[value++];
            found |= value << shift;
        }
    }
    return depth_of(found);
}

static void of_depths(const struct frob_image *image, const struct frob_view *view,
                      struct frob_statistics *result)
{
    double sum = 0, squares = 0, mean;
    int64_t n = 0;

    for (int32_t y = view->top; y < view->bottom; y++) {
        const uint8_t *row = frob_image_row(image, y);
        for (int32_t x = view->left; x < view->right; x++)
            if (is_known(bits_of(row, x))) {
                sum += depth_of(bits_of(row, x));
                n++;
            }
    }
    if (n == 0)
        return;
    mean = sum / (double)n;
    for (int32_t y = view->top; y < view->bottom; y++) {
        const uint8_t *row = frob_image_row(image, y);
        for (int32_t x = view->left; x < view->right; x++)
            if (is_known(bits_of(row, x))) {
                const double from_mean = depth_of(bits_of(row, x)) - mean;
                squares += from_mean * from_mean;
            }
    }
    result->pixels = (int32_t)n;
    result->mean = mean;
    result->stdev = sqrt(squares / (double)n);
    result->min = depth_with(image, view, 0);
    result->lq = depth_with(image, view, (n - 1) / 4);
    result->median = depth_with(image, view, (n - 1) / 2);
    result->uq = depth_with(image, view, (3 * n - 1) / 4);
    result->max = depth_with(image, view, n - 1);
}

void frob_get_statistics(const struct frob_image *image, const struct frob_region *roi,
                         struct frob_statistics *result)
{
    const struct frob_view view = frob_view_of(image, roi);
    int32_t counts[256];

    memset(result, 0, sizeof *result);
    if (image->format == FROB_DEPTH_M) {
        of_depths(image, &view, result);
        return;
    }
    count(image, &view, counts);
    of_greys(counts, result);
}

void frob_get_histogram(const struct frob_image *image, const struct frob_region *roi,
                        int32_t result[256])
{
    struct frob_view view = frob_view_of(image, roi);

    if (image->format == FROB_DEPTH_M)
        view.bottom = view.top;
    count(image, &view, result);
}
