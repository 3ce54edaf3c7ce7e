/* Tests brightness and depth of regions, edges, corners and lenses: against sorting, a slow
 * version, and drawn images. */
#include "picture.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 64 };

static const double degree = 0.017453292519943295;

static double grey(const struct frob_image *image, int32_t x, int32_t y)
{
    const uint8_t *p = frob_image_row(image, y) + x * frob_image_pixel_size(image->format);
    return image->format == FROB_RGB8 ? floor((77 * p[0] + 150 * p[1] + 29 * p[2]) / 256.0 + 0.5)
                                      : p[0];
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* ---- Statistics, by sorting */

static void statistics_of_random_regions(void)
{
    static double values[SIDE * SIDE];

    for (int k = 0; k < 3000; k++) {
        struct frob_image *image = random_picture(SIDE);
        const struct frob_region roi = random_region(image);
        struct frob_statistics s;
        int32_t counts[256], expected[256] = { 0 }, n = 0;
        double sum = 0, squares = 0;
        for (int32_t y = 0; y < image->height; y++)
            for (int32_t x = 0; x < image->width; x++) {
                double value;
                if (!(x >= roi.x && x < roi.x + roi.width && y >= roi.y && y < roi.y + roi.height))
                    continue;
                if (image->format == FROB_DEPTH_M) {
                    float depth;
                    memcpy(&depth, frob_image_row(image, y) + 4 * x, 4);
                    if (!(depth > 0 && depth < INFINITY))
                        continue;
                    value = (double)depth;
                } else {
                    value = grey(image, x, y);
                    expected[(int)value]++;
                }
                values[n++] = value;
                sum += value;
            }
        frob_get_statistics(image, &roi, &s);
        frob_get_histogram(image, &roi, counts);
        check(memcmp(counts, expected, sizeof counts) == 0, "histogram", 0, 0);
        check(s.pixels == n, "pixels", s.pixels, n);
        if (n > 0 && s.pixels == n) {
            qsort(values, (size_t)n, sizeof *values, ascending);
            for (int32_t i = 0; i < n; i++)
                squares += (values[i] - sum / n) * (values[i] - sum / n);
            check(fabs(s.mean - sum / n) <= 1e-12 * fabs(sum / n), "mean", s.mean, sum / n);
            check(fabs(s.stdev - sqrt(squares / n)) <= 1e-6 * (1 + sqrt(squares / n)), "stdev",
                  s.stdev, sqrt(squares / n));
            check(s.min == values[0], "min", s.min, values[0]);
            check(s.lq == values[(n - 1) / 4], "lq", s.lq, values[(n - 1) / 4]);
            check(s.median == values[(n - 1) / 2], "median", s.median, values[(n - 1) / 2]);
            check(s.uq == values[(3 * n - 1) / 4], "uq", s.uq, values[(3 * n - 1) / 4]);
            check(s.max == values[n - 1], "max", s.max, values[n - 1]);
        } else {
            check(s.mean == 0 && s.max == 0, "nothing", s.mean, 0);
        }
        picture_free(image);
    }
}

/* ---- Edges */

/* A border: beyond `distance` in direction (c, s), the image is bright. */
struct border {
    double c, s, distance, dark, bright;
};

static double border_shade(const void *scene, double x, double y)
{
    const struct border *b = (const struct border *)scene;
    return x * b->c + y * b->s > b->distance ? b->bright : b->dark;
}

static void edges_where_they_were_drawn(void)
{
    double worst = 0;

    for (int k = 0; k < 200; k++) {
        struct frob_image *image = picture(SIDE, SIDE, FROB_GREY8);
        const double angle = 360 * degree * random_share(), truth = 8 * random_share() - 4;
        const struct frob_segment segment = { 28 + 8 * random_share(), 28 + 8 * random_share(),
                                              angle, 16, 1 + random_below(12) };
        const struct border b = { cos(angle), sin(angle),
                                  segment.x * cos(angle) + segment.y * sin(angle) + truth,
                                  60 * random_share(), 120 + 130 * random_share() };
        struct frob_segment back = segment;
        struct frob_edges there, again;
        draw(image, 16, border_shade, &b);
        frob_find_edges(image, &segment, &there);
        check(there.rising.gradient > 20, "the rise", there.rising.gradient, 20);
        check(there.falling.gradient > -2, "no fall", there.falling.gradient, 0);
        worst = fmax(worst, fabs(there.rising.offset - truth));
        /* Searching from the other side, the brightness falls at the same place. */
        back.angle += 180 * degree;
        frob_find_edges(image, &back, &again);
        check(fabs(again.falling.offset + there.rising.offset) < 1e-6, "and back",
              again.falling.offset, -there.rising.offset);
        check(fabs(again.falling.gradient + there.rising.gradient) < 1e-6, "its fall",
              again.falling.gradient, -there.rising.gradient);
        picture_free(image);
    }
    check(worst < 0.08, "edges, px", worst, 0.08);
}

static void no_edges(void)
{
    struct frob_image *flat = picture(SIDE, SIDE, FROB_GREY8);
    const struct frob_segment across_border = { -2, 30, 0, 20, 3 }, away = { 500, 500, 1, 20, 3 };
    struct frob_edges edges;

    memset((void *)(uintptr_t)flat->pixels, 200, SIDE * SIDE);
    frob_find_edges(flat, &across_border, &edges);
    check(edges.rising.gradient == 0 && edges.falling.gradient == 0, "the border is no edge",
          edges.rising.gradient, 0);
    frob_find_edges(flat, &away, &edges);
    check(edges.rising.gradient == 0 && edges.falling.gradient == 0, "nothing out there",
          edges.rising.gradient, 0);
    picture_free(flat);
}

/* ---- Corners */

static double score(const struct frob_image *image, int32_t x, int32_t y)
{
    double xx = 0, xy = 0, yy = 0;

    for (int32_t j = y - 2; j <= y + 2; j++)
        for (int32_t i = x - 2; i <= x + 2; i++) {
            const double gx = (grey(image, i + 1, j) - grey(image, i - 1, j)) / 2;
            const double gy = (grey(image, i, j + 1) - grey(image, i, j - 1)) / 2;
            xx += gx * gx / 25;
            xy += gx * gy / 25;
            yy += gy * gy / 25;
        }
    return (xx + yy) / 2 - hypot((xx - yy) / 2, xy);
}

static void best_corners_of_random_images(void)
{
    int found = 0;

    for (int k = 0; k < 600; k++) {
        struct frob_image *image = random_picture(SIDE);
        const struct frob_region roi = random_region(image);
        struct frob_corner corner;
        double best = 0, best_x = 0, best_y = 0;
        frob_find_corner(image, &roi, &corner);
        for (int32_t y = 3; y < image->height - 3 && image->format != FROB_DEPTH_M; y++)
            for (int32_t x = 3; x < image->width - 3; x++)
                if (x >= roi.x && x < roi.x + roi.width && y >= roi.y && y < roi.y + roi.height) {
                    const double here = score(image, x, y);
                    if (here > best + 1e-6) {
                        best = here;
                        best_x = x;
                        best_y = y;
                    }
                }
        check(fabs(corner.score - best) < 1e-5, "the best score", corner.score, best);
        if (corner.score > 1e-4)
            check(hypot(corner.x - best_x, corner.y - best_y) < 9, "its place", corner.x, best_x);
        found += corner.score > 0;
        picture_free(image);
    }
    check(found > 60, "corners", found, 60);
}

struct quadrant {
    double x, y, angle;
};

static double quadrant_shade(const void *scene, double x, double y)
{
    const struct quadrant *q = (const struct quadrant *)scene;
    const double a = (x - q->x) * cos(q->angle) + (y - q->y) * sin(q->angle);
    const double b = (y - q->y) * cos(q->angle) - (x - q->x) * sin(q->angle);
    return a > 0 && b > 0 ? 220 : 40;
}

static void corners_where_they_were_drawn(void)
{
    double worst = 0;

    for (int k = 0; k < 30; k++) {
        struct frob_image *image = picture(SIDE, SIDE, FROB_GREY8);
        const struct quadrant q = { 25 + 15 * random_share(), 25 + 15 * random_share(),
                                    6.28 * random_share() };
        struct frob_corner corner;
        draw(image, 16, quadrant_shade, &q);
        frob_find_corner(image, &everywhere, &corner);
        worst = fmax(worst, hypot(corner.x - q.x, corner.y - q.y));
        picture_free(image);
    }
    check(worst < 0.35, "corners, px", worst, 0.35);
}

/* ---- Lenses */

static void lenses_there_and_back(void)
{
    struct frob_image *image = picture(SIDE, SIDE, FROB_GREY8);
    struct frob_camera *c = &image->camera;
    double worst = 0;

    image->width = 320;
    image->height = 240;
    c->focal_x = 250;
    c->focal_y = 245;
    c->centre_x = 158;
    c->centre_y = 121;
    c->k1 = -0.32;
    c->k2 = 0.11;
    c->k3 = -0.01;
    c->p1 = 0.002;
    c->p2 = -0.001;
    for (int k = 0; k < 5000; k++) {
        const struct frob_vec2 seen = { 320 * random_share(), 240 * random_share() };
        struct frob_vec2 straight, again;
        frob_undistort_point(image, &seen, &straight);
        frob_distort_point(image, &straight, &again);
        worst = fmax(worst, hypot(again.x - seen.x, again.y - seen.y));
    }
    check(worst < 1e-6, "there and back, px", worst, 0);
    {
        /* The model's formula at one point: a = 0.4, b = -0.2. */
        const struct frob_vec2 straight = { 158 + 250 * 0.4, 121 - 245 * 0.2 };
        const double r2 = 0.2, radial = 1 - 0.32 * r2 + 0.11 * r2 * r2 - 0.01 * r2 * r2 * r2;
        const double a = 0.4 * radial + 2 * 0.002 * -0.08 - 0.001 * (r2 + 2 * 0.16);
        const double b = -0.2 * radial + 0.002 * (r2 + 2 * 0.04) + 2 * -0.001 * -0.08;
        struct frob_vec2 seen;
        frob_distort_point(image, &straight, &seen);
        check(fabs(seen.x - (158 + 250 * a)) < 1e-9, "x of the formula", seen.x, 158 + 250 * a);
        check(fabs(seen.y - (121 + 245 * b)) < 1e-9, "y of the formula", seen.y, 121 + 245 * b);
    }
    {
        /* Far outside the region where the model is invertible. */
        const struct frob_vec2 far = { 5000, 5000 };
        struct frob_vec2 found;
        frob_undistort_point(image, &far, &found);
        check(found.x == far.x && found.y == far.y, "none", found.x, far.x);
    }
    image->width = image->height = SIDE;
    picture_free(image);
}

int main(void)
{
    statistics_of_random_regions();
    edges_where_they_were_drawn();
    no_edges();
    best_corners_of_random_images();
    corners_where_they_were_drawn();
    lenses_there_and_back();
    printf("regions: %d failures\n", failures());
    return failures() > 0;
}
