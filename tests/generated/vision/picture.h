/* picture.h -- images for tests: random ones, and drawn ones whose truth is known. */
#ifndef PICTURE_H
#define PICTURE_H

#include <frob/vision.h>

/* An image with its pixels in memory of its own, as tight as its stride says. */
struct frob_image *picture(int32_t width, int32_t height, enum frob_image_format format);
void picture_free(struct frob_image *image);

/* The whole of any image. */
extern const struct frob_region everywhere;

/* Random numbers, the same in every run: 32 bits; 0 … n - 1; 0 … 1. */
uint32_t random_bits(void);
int32_t random_below(int32_t n);
double random_share(void);

/* Sides of 0, 1, odd and even; a stride that may be longer than a row; any bytes. */
struct frob_image *random_picture(int32_t most_side);

/* Any double: whole, fractions, huge, infinite, NaN. */
double random_number(void);

/* A region that may be anywhere, or half outside. */
struct frob_region random_region(const struct frob_image *image);

/* Makes each pixel what `shade` says of its square: brightness, the mean of parts by
 * parts places. */
void draw(struct frob_image *image, int32_t parts,
          double (*shade)(const void *scene, double x, double y), const void *scene);

/* Counts failures; the first ones are printed with their numbers. */
void check(bool ok, const char *what, double found, double expected);
int failures(void);

#endif
