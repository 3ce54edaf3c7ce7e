/* frames KIND COUNT WIDTH HEIGHT [FIRST] -- writes pictures to standard output, each different
 * from the one before: a square moves from left to right across a grey background that gets
 * brighter. KIND is jpeg, ppm, pgm, rgb (raw) or yuyv. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hosts/camera/turbo.h"

static unsigned char *draw(int k, int width, int height, int bytes)
{
    unsigned char *pixels = (unsigned char *)malloc((size_t)(width * height * bytes));
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            unsigned char *p = pixels + (size_t)((y * width + x) * bytes);
            const int at = 5 * k % width, in = x >= at && x < at + 20 && y > 20 && y < 40;
            memset(p, 40 + 2 * (k % 60), (size_t)bytes);
            if (in)
                p[0] = 250;
        }
    return pixels;
}

static void write_jpeg(const unsigned char *pixels, int width, int height)
{
    const char *fault = NULL;
    const struct turbo *turbo = turbo_find(&fault);
    unsigned char *jpeg = NULL;
    unsigned long size = 0;
    if (turbo == NULL) {
        fprintf(stderr, "%s\n", fault);
        exit(2);
    }
    turbo->compress(turbo->init_compress(), pixels, width, 0, height, TURBO_RGB, &jpeg, &size,
                    TURBO_SAMPLES_422, 85, 0);
    fwrite(jpeg, 1, size, stdout);
    turbo->release(jpeg);
}

int main(int argc, char **argv)
{
    const char *kind = argv[1];
    const int count = atoi(argv[2]), width = atoi(argv[3]), height = atoi(argv[4]);
    const int first = argc > 5 ? atoi(argv[5]) : 0;
    for (int k = first; k < first + count; k++) {
        const int bytes = strcmp(kind, "pgm") == 0 ? 1 : strcmp(kind, "yuyv") == 0 ? 2 : 3;
        unsigned char *pixels = draw(k, width, height, bytes);
        if (strcmp(kind, "jpeg") == 0) {
            write_jpeg(pixels, width, height);
        } else {
            if (strcmp(kind, "ppm") == 0 || strcmp(kind, "pgm") == 0)
                printf("P%d\n%d %d\n255\n", bytes == 1 ? 5 : 6, width, height);
            fwrite(pixels, 1, (size_t)(width * height * bytes), stdout);
        }
        free(pixels);
    }
    return fflush(stdout) == 0 ? 0 : 1;
}
