#include "picture.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const struct frob_region everywhere = { -1e6, -1e6, 1e9, 1e9 };

static int failed;

void check(bool ok, const char *what, double found, double expected)
{
    if (ok)
        return;
    if (failed++ < 20)
        printf("FAIL %s: %.17g, expected %.17g\n", what, found, expected);
}

int failures(void)
{
    return failed;
}

static uint64_t seed = 1;

uint32_t random_bits(void)
{
    uint64_t z = (seed += UINT64_C(0x9e3779b97f4a7c15));
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return (uint32_t)((z ^ (z >> 31)) >> 32);
}

int32_t random_below(int32_t n)
{
    return (int32_t)(random_bits() % (uint32_t)n);
}

double random_share(void)
{
    return random_bits() / 4294967296.0;
}

static struct frob_image *with_stride(int32_t width, int32_t height, enum frob_image_format format,
                                      int32_t more)
{
    struct frob_image *image = calloc(1, sizeof *image);
    const int32_t size = frob_image_pixel_size(format);
    size_t bytes;

    if (image == NULL)
        abort();
    image->width = width;
    image->height = height;
    image->format = format;
    image->stride = (width + more) * size;
    /* The buffer ends with the last pixel of the last row, so that sanitizers detect reads
       beyond it. */
    bytes = height > 0 ? (size_t)image->stride * (size_t)(height - 1) + (size_t)(width * size) : 0;
    image->pixels = calloc(bytes > 0 ? bytes : 1, 1);
    image->camera.focal_x = image->camera.focal_y = 300;
    image->camera.centre_x = (width - 1) / 2.0;
    image->camera.centre_y = (height - 1) / 2.0;
    return image;
}

struct frob_image *picture(int32_t width, int32_t height, enum frob_image_format format)
{
    return with_stride(width, height, format, 0);
}

void picture_free(struct frob_image *image)
{
    free((void *)(uintptr_t)image->pixels);
    free(image);
}

struct frob_image *random_picture(int32_t most_side)
{
    const enum frob_image_format format = (enum frob_image_format)random_below(3);
    const int32_t width = random_below(4) == 0 ? random_below(3) : random_below(most_side + 1);
    const int32_t height = random_below(4) == 0 ? random_below(3) : random_below(most_side + 1);
    struct frob_image *image = with_stride(width, height, format, random_below(2) * 3);
    /* Smooth, rough, or with few different values. */
    const int32_t kind = random_below(3);

    for (int32_t y = 0; y < height; y++)
        for (int32_t x = 0; x < width; x++) {
            uint8_t *pixel =
                (uint8_t *)(uintptr_t)frob_image_row(image, y) + x * frob_image_pixel_size(format);
            if (format == FROB_DEPTH_M) {
                const float depth =
                    (float)(random_below(8) == 0 ? random_number() : 5 * random_share());
                memcpy(pixel, &depth, sizeof depth);
                continue;
            }
            for (int32_t c = 0; c < frob_image_pixel_size(format); c++)
                pixel[c] = (uint8_t)(kind == 0   ? (x * 3 + y * 2 + c * 40)
                                     : kind == 1 ? random_below(256)
                                                 : random_below(2) * 255);
        }
    return image;
}

double random_number(void)
{
    static const double odd[] = {
        0,     -0.0,     1,         -1, 1e-300, 1e9, -1e9, 2147483648.0, -2147483649.0,
        1e300, INFINITY, -INFINITY, NAN
    };
    switch (random_below(3)) {
    case 0: return odd[random_below((int32_t)(sizeof odd / sizeof *odd))];
    case 1: return random_below(40) - 20;
    default: return 40 * random_share() - 10;
    }
}

struct frob_region random_region(const struct frob_image *image)
{
    struct frob_region roi;

    if (random_below(4) == 0)
        return everywhere;
    roi.x = random_below(6) == 0 ? random_number() : random_below(image->width + 8) - 4;
    roi.y = random_below(6) == 0 ? random_number() : random_below(image->height + 8) - 4;
    roi.width = random_below(6) == 0 ? random_number() : random_below(image->width + 8);
    roi.height = random_below(6) == 0 ? random_number() : random_below(image->height + 8);
    return roi;
}

void draw(struct frob_image *image, int32_t parts,
          double (*shade)(const void *scene, double x, double y), const void *scene)
{
    for (int32_t y = 0; y < image->height; y++)
        for (int32_t x = 0; x < image->width; x++) {
            double sum = 0;
            for (int32_t i = 0; i < parts; i++)
                for (int32_t j = 0; j < parts; j++)
                    sum += shade(scene, x - 0.5 + (i + 0.5) / parts, y - 0.5 + (j + 0.5) / parts);
            ((uint8_t *)(uintptr_t)frob_image_row(image, y))[x] =
                (uint8_t)(sum / (parts * parts) + 0.5);
        }
}
