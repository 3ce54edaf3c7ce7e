/* tag_place.c -- computes the pose of a square in space from its four corners in an image.
 *
 * Four corners determine a homography, whose columns are two sides and the centre of the square (as
 * in Zhang, "A flexible new technique for camera calibration", 2000). From far away, a square that
 * is tilted in one direction looks nearly the same as one that is tilted in the opposite direction
 * (Schweighofer and Pinz, "Robust pose estimation from a planar target", 2006). Therefore both
 * poses are refined by least squares, and the pose whose corners are closer to the observed ones is
 * chosen. */
#include "points.h"

#include <frob/lens.h>

#include <math.h>
#include <string.h>

enum { ROUNDS = 20, FREEDOM = 6 };

/* Corner positions in units of half a side, in the order of struct frob_tag. For a viewer who faces
 * the tag, x is to the right and y down. */
static const double corner_x[4] = { -1, 1, 1, -1 }, corner_y[4] = { 1, 1, -1, -1 };

struct vector {
    double x, y, z;
};

/* The directions of the square's axes, and its centre, in units of half a side. */
struct pose {
    struct vector right, down, middle;
};

static struct vector plus(struct vector a, double k, struct vector b)
{
    const struct vector sum = { a.x + k * b.x, a.y + k * b.y, a.z + k * b.z };
    return sum;
}

static double dot(struct vector a, struct vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static struct vector cross(struct vector a, struct vector b)
{
    const struct vector c = { a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x };
    return c;
}

static struct vector scaled(double k, struct vector a)
{
    const struct vector b = { k * a.x, k * a.y, k * a.z };
    return b;
}

/* Makes the two axes orthonormal, by changing both equally. */
static void straighten(struct pose *p)
{
    const double off = dot(p->right, p->down) / 2;
    const struct vector right = plus(p->right, -off, p->down);
    const struct vector down = plus(p->down, -off, p->right);
    p->right = scaled(1 / sqrt(dot(right, right)), right);
    p->down = plus(down, -dot(p->right, down), p->right);
    p->down = scaled(1 / sqrt(dot(p->down, p->down)), p->down);
}

/* Computes the pose from the homography that maps the square to the corners, in normalized image
 * coordinates. Returns false if there is no such pose. */
static bool first_guess(const double x[4], const double y[4], struct pose *p)
{
    /* Heckbert's homography from the unit square, with its corners in the order 3, 2, 1, 0,
     * starting at the upper left. */
    const double dx1 = x[2] - x[1], dx2 = x[0] - x[1], dx3 = x[3] - x[2] + x[1] - x[0];
    const double dy1 = y[2] - y[1], dy2 = y[0] - y[1], dy3 = y[3] - y[2] + y[1] - y[0];
    const double determinant = dx1 * dy2 - dx2 * dy1;
    const double g = (dx3 * dy2 - dx2 * dy3) / determinant;
    const double h = (dx1 * dy3 - dx3 * dy1) / determinant;
    const struct vector right = { (x[2] - x[3] + g * x[2]) / 2, (y[2] - y[3] + g * y[2]) / 2,
                                  g / 2 };
    const struct vector down = { (x[0] - x[3] + h * x[0]) / 2, (y[0] - y[3] + h * y[0]) / 2,
                                 h / 2 };
    const struct vector corner = { x[3], y[3], 1 };
    double length;

    /* The corners must be counter-clockwise in the image. */
    for (int32_t i = 0; i < 4; i++) {
        const int32_t j = (i + 1) & 3, k = (i + 2) & 3;
        if (!((x[j] - x[i]) * (y[k] - y[j]) - (y[j] - y[i]) * (x[k] - x[j]) < 0))
            return false;
    }
    length = (sqrt(dot(right, right)) + sqrt(dot(down, down))) / 2;
    p->right = scaled(1 / length, right);
    p->down = scaled(1 / length, down);
    p->middle = scaled(1 / length, plus(plus(corner, 1, right), 1, down));
    straighten(p);
    return p->middle.z > 0;
}

/* Returns the pose that is tilted in the opposite direction: reflected in the plane perpendicular
 * to the ray to its centre. */
static struct pose other_way(const struct pose *p)
{
    const struct vector ray = scaled(1 / sqrt(dot(p->middle, p->middle)), p->middle);
    struct pose other = *p;
    other.right = plus(p->right, -2 * dot(p->right, ray), ray);
    other.down = plus(p->down, -2 * dot(p->down, ray), ray);
    return other;
}

/* Solves a x = b for a symmetric positive definite matrix (Cholesky). */
static bool solve(double a[FREEDOM][FREEDOM], double b[FREEDOM])
{
    for (int32_t i = 0; i < FREEDOM; i++) {
        for (int32_t j = 0; j <= i; j++) {
            double sum = a[i][j];
            for (int32_t k = 0; k < j; k++)
                sum -= a[i][k] * a[j][k];
            if (i == j && !(sum > 0))
                return false;
            a[i][j] = i == j ? sqrt(sum) : sum / a[j][j];
        }
    }
    for (int32_t i = 0; i < FREEDOM; i++) {
        for (int32_t k = 0; k < i; k++)
            b[i] -= a[i][k] * b[k];
        b[i] /= a[i][i];
    }
    for (int32_t i = FREEDOM - 1; i >= 0; i--) {
        for (int32_t k = i + 1; k < FREEDOM; k++)
            b[i] -= a[k][i] * b[k];
        b[i] /= a[i][i];
    }
    return true;
}

/* Returns the sum of the squared distances between the observed and the predicted corners, in
 * normalized image coordinates; infinity if a corner is not in front of the camera. If a matrix is
 * passed, also computes the normal equations for a step, which consists of rotations about the
 * camera's three axes and translations along them. */
static double misfit(const struct pose *p, const double x[4], const double y[4],
                     double a[FREEDOM][FREEDOM], double b[FREEDOM])
{
    double sum = 0;
    for (int32_t i = 0; a != NULL && i < FREEDOM; i++) {
        b[i] = 0;
        for (int32_t j = 0; j < FREEDOM; j++)
            a[i][j] = 0;
    }
    for (int32_t i = 0; i < 4; i++) {
        const struct vector arm = plus(scaled(corner_x[i], p->right), corner_y[i], p->down);
        const struct vector at = plus(p->middle, 1, arm);
        const double off_x = x[i] - at.x / at.z, off_y = y[i] - at.y / at.z;
        if (!(at.z > 0))
            return INFINITY;
        sum += off_x * off_x + off_y * off_y;
        if (a != NULL) {
            /* The derivative of `at` with respect to a rotation w is w x arm. */
            const double along_x[3] = { 1 / at.z, 0, -at.x / (at.z * at.z) };
            const double along_y[3] = { 0, 1 / at.z, -at.y / (at.z * at.z) };
            const double rows[2][FREEDOM] = {
                { along_x[2] * arm.y, along_x[0] * arm.z - along_x[2] * arm.x, -along_x[0] * arm.y,
                  along_x[0], 0, along_x[2] },
                { along_y[2] * arm.y - along_y[1] * arm.z, -along_y[2] * arm.x, along_y[1] * arm.x,
                  0, along_y[1], along_y[2] }
            };
            for (int32_t j = 0; j < FREEDOM; j++) {
                b[j] += rows[0][j] * off_x + rows[1][j] * off_y;
                for (int32_t k = 0; k < FREEDOM; k++)
                    a[j][k] += rows[0][j] * rows[0][k] + rows[1][j] * rows[1][k];
            }
        }
    }
    return sum;
}

/* The Levenberg-Marquardt method: steps that do not reduce the error are made shorter and closer to
 * the direction of steepest descent. */
static double improve(struct pose *p, const double x[4], const double y[4])
{
    double a[FREEDOM][FREEDOM], b[FREEDOM], damping = 0;
    double best = misfit(p, x, y, a, b);
    for (int32_t round = 0; round < ROUNDS && best < INFINITY; round++) {
        struct vector turn, move;
        struct pose next = *p;
        double fit;
        for (int32_t i = 0; i < FREEDOM; i++)
            a[i][i] += damping * a[i][i];
        if (!solve(a, b))
            break;
        turn.x = b[0], turn.y = b[1], turn.z = b[2];
        move.x = b[3], move.y = b[4], move.z = b[5];
        next.right = plus(p->right, 1, cross(turn, p->right));
        next.down = plus(p->down, 1, cross(turn, p->down));
        next.middle = plus(p->middle, 1, move);
        straighten(&next);
        fit = misfit(&next, x, y, NULL, NULL);
        damping = fit < best ? damping / 8 : 8 * damping + 1e-3;
        if (fit < best) {
            *p = next;
            best = fit;
        }
        misfit(p, x, y, a, b);
    }
    return best;
}

/* Returns whether two poses face directions less than half a degree apart. */
static bool is_same(const struct pose *one, const struct pose *other)
{
    const struct vector off =
        plus(cross(one->down, one->right), -1, cross(other->down, other->right));
    return dot(off, off) < 1e-4;
}

static void unknown(struct frob_tag_place *result)
{
    result->middle.x = result->middle.y = result->middle.z = NAN;
    result->facing = result->middle;
    result->residual = result->ambiguity = NAN;
}

static struct frob_camera camera_of(const struct frob_lens *lens)
{
    struct frob_camera camera;
    memset(&camera, 0, sizeof camera);
    camera.focal_x = lens->focalX;
    camera.focal_y = lens->focalY;
    camera.centre_x = lens->centreX;
    camera.centre_y = lens->centreY;
    camera.k1 = lens->k1;
    camera.k2 = lens->k2;
    camera.k3 = lens->k3;
    camera.p1 = lens->p1;
    camera.p2 = lens->p2;
    return camera;
}

void frob_find_tag_place(const struct frob_lens *lens, double size, const struct frob_tag *tag,
                         struct frob_tag_place *result)
{
    const struct frob_camera camera = camera_of(lens);
    struct pose one, other, kept;
    struct vector facing;
    double x[4], y[4], fit, other_fit;

    unknown(result);
    if (!(lens->focalX > 0) || !(lens->focalY > 0) || !(size > 0) || !(size < INFINITY))
        return;
    for (int32_t i = 0; i < 4; i++) {
        struct frob_vec2 straight;
        frob_undistort(&camera, &tag->corners[i], &straight);
        x[i] = (straight.x - lens->centreX) / lens->focalX;
        y[i] = (straight.y - lens->centreY) / lens->focalY;
    }
    if (!first_guess(x, y, &one))
        return;
    other = other_way(&one);
    fit = improve(&one, x, y);
    other_fit = improve(&other, x, y);
    if (other_fit < fit) {
        const double larger = fit;
        kept = one;
        one = other;
        other = kept;
        fit = other_fit;
        other_fit = larger;
    }
    if (!(fit < INFINITY))
        return;
    facing = cross(one.down, one.right);
    result->middle.x = size / 2 * one.middle.x;
    result->middle.y = size / 2 * one.middle.y;
    result->middle.z = size / 2 * one.middle.z;
    result->facing.x = facing.x;
    result->facing.y = facing.y;
    result->facing.z = facing.z;
    result->residual = lens->focalX * sqrt(fit / 4);
    /* At close range both poses may converge to the same one. */
    if (is_same(&one, &other))
        result->ambiguity = 0;
    else
        result->ambiguity = sqrt(fit / other_fit);
}
