/* Measures the vision kernels. Prints JSON, one object a line: medians of many calls in
 * milliseconds, compared with the goals. With arguments, it measures stereo only, and writes the
 * disparities.
 *
 *   kernels                 the table
 *   kernels W H DISPARITIES WINDOW LEFT RIGHT OUT
 *                           grey pixels of two files; prints the least time of 15, and
 *                           writes disparities */
#include <frob/vision.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { WIDTH = 320, HEIGHT = 240 };

static double now_ms(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec * 1e-6;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* An orange ball above a floor, with noise everywhere, as from a camera. */
static uint8_t colours[HEIGHT][WIDTH][3];
static uint8_t greys[HEIGHT][WIDTH], others[HEIGHT][WIDTH];
static struct frob_image colour, grey, other;
static double patch[FROB_PATCH_SIZE];

static uint8_t noisy(double value)
{
    static uint32_t seed = 1;
    seed = seed * 1664525u + 1013904223u;
    value += (seed >> 24) / 256.0 * 16 - 8;
    return (uint8_t)(value < 0 ? 0 : value > 255 ? 255 : value);
}

static void make(struct frob_image *image, enum frob_image_format format, const void *pixels)
{
    memset(image, 0, sizeof *image);
    image->width = WIDTH;
    image->height = HEIGHT;
    image->format = format;
    image->stride = WIDTH * frob_image_pixel_size(format);
    image->pixels = pixels;
}

static double texture(double x, double y)
{
    return 128 + 40 * sin(0.23 * x + 0.6 * sin(0.11 * y)) + 40 * sin(0.19 * y + 0.05 * x) +
           30 * sin(0.9 * x + 0.7 * y);
}

static void draw(void)
{
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const int ball = hypot(x - 180, y - 130) < 32;
            greys[y][x] = noisy(texture(x, y));
            others[y][x] = noisy(texture(x + 9, y));
            colours[y][x][0] = noisy(ball ? 230 : 120 + y / 4);
            colours[y][x][1] = noisy(ball ? 110 : 115 + y / 4);
            colours[y][x][2] = noisy(ball ? 30 : 105 + y / 4);
        }
    make(&colour, FROB_RGB8, colours);
    make(&grey, FROB_GREY8, greys);
    make(&other, FROB_GREY8, others);
    other.camera.y_m = -0.1;
    grey.camera.focal_x = 300;
}

/* ---- Calls */

static const struct frob_region everywhere = { 0, 0, WIDTH, HEIGHT };
static const struct frob_colour_range orange = { 0.17, 0.7, 0.5, 1, 0.3, 1 };
static volatile double sink;

static void blob(void)
{
    struct frob_blob found;
    frob_find_blob(&colour, &everywhere, &orange, &found);
    sink = found.cx;
}

static void blobs(void)
{
    struct frob_blobs found;
    frob_find_blobs(&colour, &everywhere, &orange, &found);
    sink = found.largest[0].cx;
}

static void statistics(void)
{
    struct frob_statistics found;
    frob_get_statistics(&grey, &everywhere, &found);
    sink = found.mean;
}

static void edges(void)
{
    const struct frob_segment segment = { 160.3, 120.2, 0.3, 40, 10 };
    struct frob_edges found;
    frob_find_edges(&grey, &segment, &found);
    sink = found.rising.offset;
}

static void corner(void)
{
    struct frob_corner found;
    frob_find_corner(&grey, &everywhere, &found);
    sink = found.x;
}

/* The start is far enough that the search takes ten steps. */
static void match(void)
{
    const struct frob_search search = { { 163, 117, 0.15, 1.1 }, 0, 10, 4 };
    struct frob_match found;
    frob_match_patch(&grey, patch, &search, &found);
    sink = found.residual;
}

static void cut(void)
{
    const struct frob_placement place = { 163.3, 117.2, 0.15, 1.1 };
    double samples[FROB_PATCH_SIZE];
    frob_get_patch(&grey, &place, samples);
    sink = samples[0];
}

/* A thousand points through a lens with some distortion. */
static void undistort(void)
{
    struct frob_image bent = grey;
    bent.camera.k1 = -0.2;
    bent.camera.focal_y = 300;
    for (int k = 0; k < 1000; k++) {
        const struct frob_vec2 point = { k % 320, k % 240 };
        struct frob_vec2 found;
        frob_undistort_point(&bent, &point, &found);
        sink = found.x;
    }
}

static void find(void)
{
    const struct frob_placement like = { 0, 0, 0, 1 };
    struct frob_match found;
    frob_find_template(&grey, &everywhere, patch, &like, &found);
    sink = found.residual;
}

static void depths(void)
{
    const struct frob_stereo how = { { 0, 0, WIDTH, HEIGHT }, 32, 9 };
    struct frob_depths found;
    frob_stereo_depths(&grey, &other, &how, &found);
    sink = found.known;
}

static double median_of(void (*call)(void), int count)
{
    double *times = malloc((size_t)count * sizeof *times), result;

    for (int k = 0; k < count; k++) {
        const double start = now_ms();
        call();
        times[k] = now_ms() - start;
    }
    qsort(times, (size_t)count, sizeof *times, ascending);
    result = times[count / 2];
    free(times);
    return result;
}

static void row(const char *name, void (*call)(void), double aim)
{
    const double value = median_of(call, 301);

    char beside[64] = "\"reference\": null, \"ratio\": null";

    if (aim > 0)
        snprintf(beside, sizeof beside, "\"reference\": %.4f, \"ratio\": %.2f", aim, value / aim);
    printf("{\"program\": \"vision\", \"measure\": \"%s\", \"compiler\": \"gcc -O3\", "
           "\"value\": %.4f, %s, \"unit\": \"ms\"}\n",
           name, value, beside);
}

/* ---- Stereo of two files */

static void *read_file(const char *path, size_t size)
{
    FILE *file = fopen(path, "rb");
    void *bytes = malloc(size);

    if (file == NULL || bytes == NULL || fread(bytes, 1, size, file) != size) {
        fprintf(stderr, "kernels: %s is not there, or too short\n", path);
        exit(1);
    }
    fclose(file);
    return bytes;
}

static int stereo(char **arguments)
{
    const int width = atoi(arguments[0]), height = atoi(arguments[1]);
    const struct frob_stereo how = { { 0, 0, width, height },
                                     atoi(arguments[2]),
                                     atoi(arguments[3]) };
    const size_t size = (size_t)width * (size_t)height;
    const size_t room_size = frob_stereo_room(width, &how);
    uint16_t *room = malloc(room_size);
    int16_t *disparities = malloc(2 * size);
    double times[15];
    FILE *out = fopen(arguments[6], "wb");

    make(&grey, FROB_GREY8, read_file(arguments[4], size));
    make(&other, FROB_GREY8, read_file(arguments[5], size));
    grey.width = other.width = grey.stride = other.stride = width;
    grey.height = other.height = height;
    for (int k = 0; k < 15; k++) {
        const double start = now_ms();
        if (!frob_match_stereo(&grey, &other, &how, room, room_size, disparities, width))
            return 1;
        times[k] = now_ms() - start;
    }
    qsort(times, 15, sizeof *times, ascending);
    printf("%.3f\n", times[0]);
    return out == NULL || fwrite(disparities, 2, size, out) != size || fclose(out) != 0;
}

int main(int count, char **arguments)
{
    const struct frob_placement place = { 160, 120, 0, 1 };

    if (count == 8)
        return stereo(arguments + 1);
    draw();
    frob_get_patch(&grey, &place, patch);
    row("blob 320x240", blob, 0.05);
    row("8 largest blobs 320x240", blobs, 0);
    row("statistics 320x240", statistics, 0);
    row("edge 40 by 10", edges, 0);
    row("best corner 320x240", corner, 0);
    row("SSD 32x32, 10 steps", match, 0.15);
    row("patch 32x32", cut, 0);
    row("template in 320x240", find, 0);
    row("undistort 1000 points", undistort, 0);
    row("stereo 320x240x32", depths, 0);
    return 0;
}
