/* picture.h -- images for tests: random ones, and drawn ones whose truth is known. */
#ifndef PICTURE_H
#define PICTURE_H

#include <frob/vision.h>

/* An image whose pixels have their own buffer, exactly as large as the stride requires. */
struct frob_image *picture(int32_t width, int32_t height, enum frob_image_format format);
void picture_free(struct frob_image *image);

/* A region that contains all of any image. */
extern const struct frob_region everywhere;

/* Random numbers, the same in every run: 32 bits; 0 to n - 1; 0 to 1. */
uint32_t random_bits(void);
int32_t random_below(int32_t n);
double random_share(void);

/* An image with sides of 0, 1, odd or even length, a stride that may exceed the row, and random
 * bytes. */
struct frob_image *random_picture(int32_t most_side);

/* Any double: integers, fractions, huge values, infinities, NaN. */
double random_number(void);

/* A region that may be anywhere, also partly outside the image. */
struct frob_region random_region(const struct frob_image *image);

/* Sets each pixel to the brightness that `shade` returns for its square, averaged over parts by
 * parts places. */
void draw(struct frob_image *image, int32_t parts,
          double (*shade)(const void *scene, double x, double y), const void *scene);

/* Counts failures, and prints the first ones with their numbers. */
void check(bool ok, const char *what, double found, double expected);
int failures(void);

#endif
