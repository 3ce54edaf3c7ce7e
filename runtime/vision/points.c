/* points.c -- applies and removes lens distortion. */
#include "points.h"

/* The distorted position (in units of the focal length; see the model in frob/image.h), and its
 * partial derivatives with respect to the undistorted position. */
struct bent {
    double a, b, da_da, da_db, db_da, db_db;
};

static struct bent bend(const struct frob_camera *c, double a, double b)
{
    const double square = a * a + b * b;
    const double radial = 1 + square * (c->k1 + square * (c->k2 + square * c->k3));
    const double slope = 2 * (c->k1 + square * (2 * c->k2 + square * 3 * c->k3));
    struct bent to;

    to.a = a * radial + 2 * c->p1 * a * b + c->p2 * (square + 2 * a * a);
    to.b = b * radial + c->p1 * (square + 2 * b * b) + 2 * c->p2 * a * b;
    to.da_da = radial + slope * a * a + 2 * c->p1 * b + 6 * c->p2 * a;
    to.da_db = slope * a * b + 2 * c->p1 * a + 2 * c->p2 * b;
    to.db_da = to.da_db;
    to.db_db = radial + slope * b * b + 6 * c->p1 * b + 2 * c->p2 * a;
    return to;
}

static bool is_straight(const struct frob_camera *c)
{
    return !(c->focal_x > 0) || !(c->focal_y > 0) ||
           (c->k1 == 0 && c->k2 == 0 && c->k3 == 0 && c->p1 == 0 && c->p2 == 0);
}

void frob_distort_point(const struct frob_image *image, const struct frob_vec2 *point,
                        struct frob_vec2 *result)
{
    const struct frob_camera *c = &image->camera;
    struct bent to;

    *result = *point;
    if (is_straight(c))
        return;
    to = bend(c, (point->x - c->centre_x) / c->focal_x, (point->y - c->centre_y) / c->focal_y);
    result->x = c->centre_x + c->focal_x * to.a;
    result->y = c->centre_y + c->focal_y * to.b;
}

/* Inverts the model by Newton's method, starting at the distorted position. Beyond the largest
 * radius that the model can produce, the model folds over and has no inverse. */
void frob_undistort(const struct frob_camera *c, const struct frob_vec2 *point,
                    struct frob_vec2 *result)
{
    const double a = (point->x - c->centre_x) / c->focal_x;
    const double b = (point->y - c->centre_y) / c->focal_y;
    double found_a = a, found_b = b, off_a = 1, off_b = 1;

    *result = *point;
    if (is_straight(c))
        return;
    for (int32_t i = 0; i < 20; i++) {
        const struct bent to = bend(c, found_a, found_b);
        const double determinant = to.da_da * to.db_db - to.da_db * to.db_da;
        off_a = a - to.a;
        off_b = b - to.b;
        if (!(determinant > 0.01))
            return;
        found_a += (off_a * to.db_db - off_b * to.da_db) / determinant;
        found_b += (off_b * to.da_da - off_a * to.db_da) / determinant;
    }
    if (!(off_a * off_a + off_b * off_b < 1e-18))
        return;
    result->x = c->centre_x + c->focal_x * found_a;
    result->y = c->centre_y + c->focal_y * found_b;
}

void frob_undistort_point(const struct frob_image *image, const struct frob_vec2 *point,
                          struct frob_vec2 *result)
{
    frob_undistort(&image->camera, point, result);
}
