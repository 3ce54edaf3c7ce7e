/* Reduces a robot's path to corners, so that straight lines between the corners approximate the
 * path. */
#include "answers.h"

#include "../../common/truth.h"

#include <math.h>
#include <string.h>

/* Approximate maximum distance between the path and the lines, and maximum time between points.
 * Both are doubled until the number of points is small enough. */
#define CLOSE_M 0.01
#define LONG_S 1.0

struct way {
    const struct recording *recording;
    const double *xs, *ys; /* the positions; NULL for the true positions of `robot` */
    size_t robot;
    double shift_s; /* subtracted from times */
};

struct place {
    double x_m, y_m, time_s;
};

/* The directions in which the path may continue without a corner: between `low` and `high`,
 * relative to `direction`, as seen from `anchor`. */
struct cone {
    struct place anchor;
    bool is_open; /* any direction */
    double direction, low, high, farthest;
};

static struct place place_at(const struct way *way, size_t k)
{
    struct place place = { 0.0, 0.0, (double)way->recording->times[k] / 1e9 - way->shift_s };
    if (way->xs != NULL) {
        place.x_m = way->xs[k];
        place.y_m = way->ys[k];
    } else {
        struct truth truth;
        memcpy(&truth,
               (const unsigned char *)recording_truth(way->recording, k) +
                   way->robot * sizeof truth,
               sizeof truth);
        place.x_m = truth.x_m;
        place.y_m = truth.y_m;
    }
    return place;
}

static struct cone cone_at(struct place anchor)
{
    const struct cone cone = { anchor, true, 0.0, 0.0, 0.0, 0.0 };
    return cone;
}

/* Narrows the cone to the lines that pass within `close_m` of a place. Returns false if there are
 * no such lines, or if the robot has turned back. */
static bool narrow(struct cone *cone, struct place at, double close_m)
{
    const double dx = at.x_m - cone->anchor.x_m, dy = at.y_m - cone->anchor.y_m;
    const double distance = hypot(dx, dy), angle = atan2(dy, dx);
    double half, relative;
    if (distance < cone->farthest - close_m)
        return false;
    if (distance <= close_m)
        return true;
    half = asin(close_m / distance);
    if (cone->is_open) {
        cone->is_open = false;
        cone->direction = angle;
        cone->low = -half;
        cone->high = half;
    } else {
        relative = remainder(angle - cone->direction, 2 * 3.14159265358979323846);
        if (relative < cone->low || relative > cone->high)
            return false;
        cone->low = fmax(cone->low, relative - half);
        cone->high = fmin(cone->high, relative + half);
    }
    cone->farthest = fmax(cone->farthest, distance);
    return true;
}

/* Calls `visit` for the first instant, the corners and the last instant. A position that is not a
 * number counts as a corner. Returns the number of calls. */
static size_t visit_corners(const struct way *way, size_t first, double scale,
                            void (*visit)(void *context, size_t k, struct place place),
                            void *context)
{
    const size_t end = way->recording->count;
    struct cone cone = cone_at(place_at(way, first));
    size_t anchor = first, count = 1;
    visit(context, first, cone.anchor);
    for (size_t k = first + 1; k < end; k++) {
        const struct place at = place_at(way, k);
        const bool goes_on = narrow(&cone, at, CLOSE_M * scale);
        const bool is_long = at.time_s - cone.anchor.time_s >= LONG_S * scale;
        if (goes_on && !is_long && k + 1 < end)
            continue;
        /* The corner is the last instant inside the cone. */
        anchor = goes_on || k - 1 == anchor ? k : k - 1;
        cone = cone_at(place_at(way, anchor));
        visit(context, anchor, cone.anchor);
        count++;
        if (anchor < k) {
            narrow(&cone, at, CLOSE_M * scale);
            if (k + 1 == end) {
                visit(context, k, at);
                count++;
            }
        }
    }
    return count;
}

static void ignore(void *context, size_t k, struct place place)
{
    (void)context;
    (void)k;
    (void)place;
}

struct corners {
    struct buffer *answer;
    const char *comma;
    size_t last, before; /* the last instant visited, and the one visited before it */
};

static void add_corner(void *context, size_t k, struct place place)
{
    struct corners *corners = (struct corners *)context;
    buffer_format(corners->answer, "%s[", corners->comma);
    buffer_number(corners->answer, place.time_s);
    buffer_text(corners->answer, ",");
    buffer_number(corners->answer, place.x_m);
    buffer_text(corners->answer, ",");
    buffer_number(corners->answer, place.y_m);
    buffer_text(corners->answer, "]");
    corners->comma = ",";
    corners->before = corners->last;
    corners->last = k;
}

/* Appends the times and positions of at most about `most` instants. Returns the last corner, from
 * which a later request can continue the path. */
static size_t add_way(const struct way *way, size_t first, size_t most, struct buffer *answer)
{
    struct corners corners = { answer, "", first, first };
    double scale = 1.0;
    buffer_text(answer, "[");
    if (first < way->recording->count) {
        while (visit_corners(way, first, scale, ignore, NULL) > most && scale < 1e9)
            scale *= 2;
        visit_corners(way, first, scale, add_corner, &corners);
    }
    buffer_text(answer, "]");
    return corners.before;
}

void answer_path(struct view *view, size_t x, size_t y, size_t count, size_t first,
                 struct buffer *answer)
{
    const struct signal *all = view->signals.all;
    const bool known = view_knows(view, &all[x]) && view_knows(view, &all[y]);
    struct way way = { &view->recording, NULL, NULL, 0, 0.0 };
    size_t next;
    way.xs = !known ? NULL : series_of(&view->series, &all[x]);
    way.ys = !known ? NULL : series_of(&view->series, &all[y]);
    if (way.xs == NULL || way.ys == NULL) {
        answer_refusal(answer, "there are no values of these signals");
        return;
    }
    buffer_format(answer,
                  "{\"is\":\"path\",\"x\":%lu,\"y\":%lu,\"from\":%lu,\"points\":", (unsigned long)x,
                  (unsigned long)y, (unsigned long)first);
    next = add_way(&way, first, count, answer);
    buffer_format(answer, ",\"next\":%lu", (unsigned long)next);
    way.recording = &view->other.driven;
    way.shift_s = (double)view->other.shift_ns / 1e9;
    way.xs = view->other.drives ? view_other_numbers(view, &all[x]) : NULL;
    way.ys = way.xs == NULL ? NULL : view_other_numbers(view, &all[y]);
    if (way.ys != NULL) {
        buffer_text(answer, ",\"others\":");
        add_way(&way, 0, count, answer);
    }
    buffer_text(answer, "}");
}

void answer_way(struct view *view, size_t robot, size_t count, size_t first, struct buffer *answer)
{
    const struct way way = { &view->recording, NULL, NULL, robot, 0.0 };
    size_t next;
    buffer_format(answer,
                  "{\"is\":\"way\",\"robot\":%lu,\"from\":%lu,\"points\":", (unsigned long)robot,
                  (unsigned long)first);
    next = add_way(&way, first, count, answer);
    buffer_format(answer, ",\"next\":%lu}", (unsigned long)next);
}
