/* ssd.c -- finds the placement at which a patch matches best: XVision's SSD tracker.
 *
 * Least squares by the inverse compositional method (Baker and Matthews, "Lucas-Kanade 20 Years
 * On", 2004): a small step moves the patch instead of the image, so its gradients and the matrix of
 * the normal equations are computed only once. The placement is then moved by the inverse of the
 * step.
 *
 * The gradients are projected onto the orthogonal complement of the changes that brightness and
 * contrast can cause, so the match does not depend on the light. */
#include "patch.h"

#include <frob/elementary.h>

#include <math.h>

enum { SIDE = FROB_PATCH_SIDE, FREEDOMS = 4 };

/* A patch at one resolution level with its precomputed data. */
struct model {
    int32_t side, cell; /* values per side; each is the mean of cell x cell samples */
    int32_t freedom;
    double values[FROB_PATCH_SIZE]; /* minus their mean */
    double power;                   /* the sum of their squares */
    /* Derivatives of the values with respect to x, y, angle and the logarithm of the scale; and the
     * lower Cholesky factor of the matrix of the normal equations. */
    double steps[FREEDOMS][FROB_PATCH_SIZE];
    double factors[FREEDOMS][FREEDOMS];
};

/* Computes the mean of each block of cell x cell samples, minus the mean of all samples. Returns
 * the sum of the squares of these values. */
static double reduce(const double samples[FROB_PATCH_SIZE], int32_t cell, double *values)
{
    const int32_t side = SIDE / cell;
    double sum = 0, power = 0;

    for (int32_t j = 0; j < side; j++)
        for (int32_t i = 0; i < side; i++) {
            double value = 0;
            for (int32_t n = 0; n < cell; n++)
                for (int32_t m = 0; m < cell; m++)
                    value += samples[(j * cell + n) * SIDE + i * cell + m];
            value /= cell * cell;
            values[j * side + i] = value;
            sum += value;
        }
    sum /= side * side;
    for (int32_t i = 0; i < side * side; i++) {
        values[i] -= sum;
        power += values[i] * values[i];
    }
    return power;
}

static double product(const double *a, const double *b, int32_t count)
{
    double sum = 0;

    for (int32_t i = 0; i < count; i++)
        sum += a[i] * b[i];
    return sum;
}

/* Returns the derivative at one of the values, along a row or a column, per sample of the patch. */
static double slope(const double *values, int32_t stride, int32_t at, int32_t side, int32_t cell)
{
    const int32_t before = at > 0 ? -stride : 0, after = at < side - 1 ? stride : 0;

    return (values[after] - values[before]) / (cell * ((before < 0) + (after > 0)));
}

static void find_steps(struct model *t)
{
    const int32_t count = t->side * t->side;

    for (int32_t j = 0; j < t->side; j++)
        for (int32_t i = 0; i < t->side; i++) {
            const int32_t at = j * t->side + i;
            const double u = t->cell * (i - (t->side - 1) / 2.0);
            const double v = t->cell * (j - (t->side - 1) / 2.0);
            const double x = slope(t->values + at, 1, i, t->side, t->cell);
            const double y = slope(t->values + at, t->side, j, t->side, t->cell);
            t->steps[0][at] = x;
            t->steps[1][at] = y;
            t->steps[2][at] = u * y - v * x;
            t->steps[3][at] = u * x + v * y;
        }
    for (int32_t k = 0; k < t->freedom; k++) {
        const double share = product(t->steps[k], t->values, count) / t->power;
        double mean = 0;
        for (int32_t i = 0; i < count; i++)
            mean += t->steps[k][i];
        mean /= count;
        for (int32_t i = 0; i < count; i++)
            t->steps[k][i] -= mean + share * t->values[i];
    }
}

/* Performs the Cholesky factorization. If a direction is nearly a linear combination of the earlier
 * ones, sets its diagonal element to 0. */
static void factorize(struct model *t)
{
    for (int32_t k = 0; k < t->freedom; k++)
        for (int32_t m = 0; m <= k; m++) {
            const double own = product(t->steps[k], t->steps[m], t->side * t->side);
            double rest = own;
            for (int32_t i = 0; i < m; i++)
                rest -= t->factors[k][i] * t->factors[m][i];
            if (m == k)
                t->factors[k][k] = rest > 1e-6 * own && rest > 0 ? sqrt(rest) : 0;
            else
                t->factors[k][m] = t->factors[m][m] > 0 ? rest / t->factors[m][m] : 0;
        }
}

/* Prepares a patch for one level. Returns false if the patch has no contrast. */
static bool prepare(struct model *t, const double patch[FROB_PATCH_SIZE], int32_t level,
                    int32_t freedom)
{
    t->cell = 1 << level;
    t->side = SIDE / t->cell;
    t->freedom = freedom;
    t->power = reduce(patch, t->cell, t->values);
    /* This also rejects NaN. A standard deviation of 0.01 is too little contrast, and values around
     * 1e6 cannot be brightness. */
    if (!(t->power > 0.1 && t->power < 1e15))
        return false;
    find_steps(t);
    factorize(t);
    return true;
}

/* Computes the step that makes the template most similar to the values, whose contrast is `gain`
 * times the template's. */
static void solve(const struct model *t, const double *values, double gain, double step[FREEDOMS])
{
    for (int32_t k = 0; k < FREEDOMS; k++) {
        step[k] = 0;
        if (k >= t->freedom || !(t->factors[k][k] > 0))
            continue;
        step[k] = product(t->steps[k], values, t->side * t->side) / gain;
        for (int32_t i = 0; i < k; i++)
            step[k] -= t->factors[k][i] * step[i];
        step[k] /= t->factors[k][k];
    }
    for (int32_t k = t->freedom - 1; k >= 0; k--) {
        for (int32_t i = k + 1; i < t->freedom; i++)
            step[k] -= t->factors[i][k] * step[i];
        step[k] = t->factors[k][k] > 0 ? step[k] / t->factors[k][k] : 0;
    }
}

static double limited(double most, double x)
{
    return !(x > -most) ? -most : x > most ? most : x;
}

/* Moves the placement by the inverse of a step; returns the distance in samples. */
static double move(const struct model *t, const double step[FREEDOMS],
                   const struct frob_placement *from, struct frob_placement *place)
{
    const double most = 2 * t->cell;
    const double x = limited(most, step[0]), y = limited(most, step[1]);
    const double turn = limited(0.2, step[2]), growth = 1 + limited(0.2, step[3]);
    const double angle = place->angle - turn;
    const double scale = place->scale / growth;
    const double cosine = scale * frob_cos(angle), sine = scale * frob_sin(angle);

    place->x -= x * cosine - y * sine;
    place->y -= x * sine + y * cosine;
    place->angle = angle;
    place->scale = scale < from->scale / 2   ? from->scale / 2
                   : scale > from->scale * 2 ? from->scale * 2
                                             : scale;
    /* Converts the rotation and the growth to the distance that a sample at the edge of the patch
     * moves. */
    return fabs(x) + fabs(y) + SIDE / 2 * (fabs(turn) + fabs(growth - 1));
}

/* 1 - r^2, where r is the correlation; 1 if r is not positive. */
static double unlikeness(double power, double other, double both)
{
    const double rest = both > 0 && other > 0 ? 1 - both * both / (power * other) : 1;

    return rest > 0 ? rest : 0;
}

/* Searches at one level, and keeps the best match among the placements that it visits. */
static void search_level(const struct frob_greys *greys, const struct model *t, int32_t iterations,
                         struct frob_match *best)
{
    const struct frob_placement from = best->place;
    struct frob_placement place = from;
    double samples[FROB_PATCH_SIZE], values[FROB_PATCH_SIZE], step[FREEDOMS];

    best->residual = 2;
    for (int32_t n = 0; n <= iterations; n++) {
        const int32_t inside = frob_cut_patch(greys, &place, samples);
        const double power = reduce(samples, t->cell, values);
        const double both = product(t->values, values, t->side * t->side);
        const double residual =
            4 * inside < 3 * FROB_PATCH_SIZE ? 1 : sqrt(unlikeness(t->power, power, both));
        if (residual < best->residual) {
            best->place = place;
            best->residual = residual;
        }
        if (n == iterations || !(power > 0))
            return;
        solve(t, values, sqrt(power / t->power), step);
        if (move(t, step, &from, &place) < 0.01 * t->cell)
            iterations = n + 1;
    }
}

void frob_match_patch(const struct frob_image *image, const double patch[FROB_PATCH_SIZE],
                      const struct frob_search *search, struct frob_match *result)
{
    const int32_t level = search->level < 0 ? 0 : search->level > 2 ? 2 : search->level;
    const int32_t freedom = search->freedom < 2 ? 2 : search->freedom > 4 ? 4 : search->freedom;
    const int32_t iterations = search->iterations < 0    ? 0
                               : search->iterations > 30 ? 30
                                                         : search->iterations;
    struct frob_greys greys;
    struct model t;

    result->place = search->from;
    result->residual = 1;
    if (!frob_greys_around(&greys, image, &search->from, 24 * search->from.scale))
        return;
    for (int32_t k = level; k >= 0; k--) {
        struct frob_match found = *result;
        if (!prepare(&t, patch, k, freedom))
            return;
        search_level(&greys, &t, iterations, &found);
        *result = found;
    }
}
