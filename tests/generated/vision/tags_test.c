/* Tests the computation of tags' poses: with corners projected from a known pose, with and
 * without distortion and noise; and against a slow version that varies the pose until no change
 * improves the fit. */
#include "picture.h"

#include <frob/lens.h>

#include <math.h>
#include <stdio.h>

/* A tag and its pose: rotation about the camera's x, y and z axes. */
struct truth {
    double size, x, y, z, tilt, pan, spin;
};

static const struct frob_lens straight = { 320, 240, 280, 280, 159.5, 119.5, 0, 0, 0,
                                           0,   0,   0,   0,   0,     0,     0, 0 };

/* Converts a place on the tag, in metres to the right and down, to the camera's coordinates. */
static struct frob_vec3 there(const struct truth *t, double right, double down, double out)
{
    const double spun_x = cos(t->spin) * right - sin(t->spin) * down;
    const double spun_y = sin(t->spin) * right + cos(t->spin) * down;
    const double tilted_y = cos(t->tilt) * spun_y + sin(t->tilt) * out;
    const double tilted_z = sin(t->tilt) * spun_y - cos(t->tilt) * out;
    const struct frob_vec3 p = { t->x + cos(t->pan) * spun_x + sin(t->pan) * tilted_z,
                                 t->y + tilted_y,
                                 t->z - sin(t->pan) * spun_x + cos(t->pan) * tilted_z };
    return p;
}

static struct frob_tag seen(const struct frob_lens *lens, const struct truth *t, double noise)
{
    static const double right[4] = { -1, 1, 1, -1 }, down[4] = { 1, 1, -1, -1 };
    struct frob_image camera = { 0 };
    struct frob_tag tag = { 0 };
    camera.camera.focal_x = lens->focalX;
    camera.camera.focal_y = lens->focalY;
    camera.camera.centre_x = lens->centreX;
    camera.camera.centre_y = lens->centreY;
    camera.camera.k1 = lens->k1;
    camera.camera.k2 = lens->k2;
    for (int i = 0; i < 4; i++) {
        const struct frob_vec3 p = there(t, t->size / 2 * right[i], t->size / 2 * down[i], 0);
        const struct frob_vec2 flat = { lens->centreX + lens->focalX * p.x / p.z,
                                        lens->centreY + lens->focalY * p.y / p.z };
        frob_distort_point(&camera, &flat, &tag.corners[i]);
        tag.corners[i].x += noise * (2 * random_share() - 1);
        tag.corners[i].y += noise * (2 * random_share() - 1);
    }
    return tag;
}

static struct truth any_truth(void)
{
    struct truth t;
    t.size = 0.1 + 0.3 * random_share();
    t.z = 0.5 + 1.5 * random_share();
    t.x = t.z * 0.4 * (2 * random_share() - 1);
    t.y = t.z * 0.3 * (2 * random_share() - 1);
    t.tilt = 0.5 * (2 * random_share() - 1);
    t.pan = 0.9 * (2 * random_share() - 1);
    t.spin = 3 * (2 * random_share() - 1);
    return t;
}

static double apart(struct frob_vec3 a, struct frob_vec3 b)
{
    return sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

static struct frob_vec3 facing(const struct truth *t)
{
    const struct frob_vec3 middle = there(t, 0, 0, 0), out = there(t, 0, 0, 1);
    const struct frob_vec3 way = { out.x - middle.x, out.y - middle.y, out.z - middle.z };
    return way;
}

static void places_are_found(void)
{
    struct frob_lens bent = straight;
    bent.k1 = -0.2;
    bent.k2 = 0.03;
    for (int k = 0; k < 2000; k++) {
        const struct frob_lens *lens = k % 2 ? &bent : &straight;
        const struct truth t = any_truth();
        const struct frob_tag tag = seen(lens, &t, 0);
        const struct frob_vec3 middle = there(&t, 0, 0, 0);
        struct frob_tag_place place;
        frob_find_tag_place(lens, t.size, &tag, &place);
        check(apart(place.middle, middle) < 1e-6, "the middle", apart(place.middle, middle), k);
        check(apart(place.facing, facing(&t)) < 1e-5, "where it looks",
              apart(place.facing, facing(&t)), k);
        check(place.residual < 1e-6 && place.ambiguity < 0.01, "certain", place.residual,
              place.ambiguity);
    }
}

static double misfit(const struct frob_tag *tag, const struct truth *t)
{
    const struct frob_tag other = seen(&straight, t, 0);
    double sum = 0;
    for (int i = 0; i < 4; i++) {
        const double x = other.corners[i].x - tag->corners[i].x;
        const double y = other.corners[i].y - tag->corners[i].y;
        sum += x * x + y * y;
    }
    return sqrt(sum / 4);
}

/* Starting from the true pose, repeats any single step that improves the fit, with smaller and
 * smaller steps. */
static double slow(const struct frob_tag *tag, struct truth t)
{
    double *const parts[] = { &t.x, &t.y, &t.z, &t.tilt, &t.pan, &t.spin };
    double best = misfit(tag, &t);
    for (double step = 0.05; step > 1e-9;) {
        bool better = false;
        for (int i = 0; i < 6; i++)
            for (int way = -1; way <= 1; way += 2) {
                const double before = *parts[i];
                double fit;
                *parts[i] = before + way * step;
                fit = misfit(tag, &t);
                if (fit < best) {
                    best = fit;
                    better = true;
                } else {
                    *parts[i] = before;
                }
            }
        if (!better)
            step /= 2;
    }
    return best;
}

static void none_fits_better(void)
{
    for (int k = 0; k < 60; k++) {
        const struct truth t = any_truth();
        const struct frob_tag tag = seen(&straight, &t, 0.5);
        struct frob_tag_place place;
        double judge;
        frob_find_tag_place(&straight, t.size, &tag, &place);
        judge = slow(&tag, t);
        check(place.residual < judge + 1e-4, "as good as the slow version", place.residual, judge);
    }
}

/* If a tag is small, far away and tilted, it could also be tilted in the opposite direction; the
 * result must say so. */
static void doubts_are_told(void)
{
    const struct truth far = { 0.1, 0.1, 0.05, 4, 0.3, 0.4, 0.2 };
    const struct truth near = { 0.3, 0.1, 0.05, 0.6, 0.3, 0.4, 0.2 };
    struct frob_tag tag = seen(&straight, &far, 0.1);
    struct frob_tag_place place;
    frob_find_tag_place(&straight, far.size, &tag, &place);
    check(place.ambiguity > 0.2, "doubt", place.ambiguity, 1);
    tag = seen(&straight, &near, 0.1);
    frob_find_tag_place(&straight, near.size, &tag, &place);
    check(place.ambiguity < 0.2, "no doubt", place.ambiguity, 0);
}

static void no_tags_have_no_place(void)
{
    const struct truth t = { 0.2, 0, 0, 1, 0, 0, 0 };
    const struct frob_tag good = seen(&straight, &t, 0);
    struct frob_tag tag = good;
    struct frob_tag_place place;
    for (int i = 0; i < 4; i++)
        tag.corners[i] = good.corners[3 - i];
    frob_find_tag_place(&straight, t.size, &tag, &place);
    check(isnan(place.residual), "a tag from behind", place.residual, NAN);
    tag = good;
    tag.corners[2] = tag.corners[1];
    frob_find_tag_place(&straight, t.size, &tag, &place);
    check(isnan(place.middle.x), "three corners", place.middle.x, NAN);
    frob_find_tag_place(&straight, 0, &good, &place);
    check(isnan(place.facing.z), "no size", place.facing.z, NAN);
}

int main(void)
{
    places_are_found();
    none_fits_better();
    doubts_are_told();
    no_tags_have_no_place();
    printf("tags: %d failures\n", failures());
    return failures() > 0;
}
