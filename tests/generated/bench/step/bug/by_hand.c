#include "by_hand.h"
#include "time_by_hand.h"

#include <frob/elementary.h>
#include <math.h>

static const double pi = 3.14159265358979323846;
static const double theta_max = 50 * (3.14159265358979323846 / 180);
static const double look = 15 * (3.14159265358979323846 / 180);
static const double turn_max = 1.0471975511965977462; /* pi / 3 */
static const struct place goal = { 3.0, 1.0 };
static const double radius = 0.15, keep = 0.3, room = 0.15;
static const int64_t leave_ns = 5000000000, arrived_ns = 1000000000, failed_ns = 2000000000;

/* Limits y to ±x, or to 0 if x is negative. A NaN stays NaN, so that it cannot pass for a valid
 * speed. */
static double limit(double x, double y)
{
    const double most = x < 0.0 ? 0.0 : x;
    const double high = y < most ? y : most;
    return isnan(y) ? y : high > -most ? high : -most;
}

static double least(double a, double b)
{
    return b < a || b != b ? b : a;
}

static double distance(const struct bug_input *in, struct place p)
{
    return frob_hypot(in->x - p.x, in->y - p.y);
}

/* Whether the robot has reached the place after having left it. */
static bool comes_near(struct by_hand *self, double d)
{
    const bool before = self->near_before;
    self->near_before = d < radius;
    return self->near_before && !before;
}

static void start_circle(struct by_hand *self)
{
    self->seen = false;
    self->side_dot = 0.0;
    self->near_before = false;
}

static void circle(struct by_hand *self, double dt, const struct bug_input *in,
                   struct bug_output *out)
{
    double side = keep, omega;
    if (in->side < 3.0)
        self->seen = true;
    if (self->seen)
        side = in->side;
    if (dt > 0.0)
        self->side_dot = (side - self->side_before) / dt;
    self->side_before = side;
    out->v = limit(0.35, 1.2 * (in->ahead - keep));
    omega = -8.0 * (limit(self->sin_theta_max * in->speed, -1.2 * (side - keep)) - self->side_dot);
    if (in->ahead < keep + room)
        omega = least(omega, 8.0 * (in->ahead - keep - room));
    out->omega = omega;
}

static void rest(struct by_hand *self, int64_t ns)
{
    self->state = REST;
    self->since_ns = 0;
    self->rest_ns = ns;
}

/* Runs the current state; returns whether it continues. */
static bool drive(struct by_hand *self, const struct bug_input *in, struct bug_output *out)
{
    const double way_x = goal.x - in->x, way_y = goal.y - in->y;
    const double d = frob_hypot(way_x, way_y);
    const double turn = frob_atan2(way_y, way_x) - in->heading;
    const double off = turn - 2 * pi * ceil((turn - pi) / (2 * pi));
    const bool looks = fabs(off) < look;
    if (comes_near(self, d)) {
        rest(self, arrived_ns);
        return false;
    }
    if (looks && in->ahead < least(d, 0.3)) {
        self->state = LEAVE;
        self->since_ns = 0;
        self->began.x = in->x;
        self->began.y = in->y;
        self->began_distance = self->nearest_distance = d;
        self->nearest = self->began;
        start_circle(self);
        return false;
    }
    out->v = 0.0;
    if (looks) {
        const double ahead = in->ahead - 0.15;
        out->v = least(least(d, ahead < 0.0 ? 0.0 : ahead), 0.3) * frob_cos(off);
    }
    out->omega = limit(turn_max, 2.0 * off);
    return true;
}

static void look_for_nearest(struct by_hand *self, const struct bug_input *in)
{
    const double d = distance(in, goal);
    const double nearest = self->nearest_distance;
    if (d < nearest || (nearest != nearest && d == d)) {
        self->nearest_distance = d;
        self->nearest.x = in->x;
        self->nearest.y = in->y;
    }
}

void by_hand_reset(struct by_hand *self)
{
    self->sin_theta_max = frob_sin(theta_max);
    self->since_ns = 0;
    self->state = DRIVE;
    self->started = false;
    self->near_before = false;
}

void by_hand_step(struct by_hand *self, int64_t dt_ns, double dt, const struct bug_input *in,
                  struct bug_output *out)
{
    self->since_ns += dt_ns;
    if (self->state == LEAVE || self->state == RETURN)
        look_for_nearest(self, in);
    /* When a state ends, the next one starts in the same instant. */
    for (;;) {
        switch (self->state) {
        case DRIVE:
            if (drive(self, in, out))
                return;
            break;
        case LEAVE:
            if (self->since_ns < leave_ns) {
                circle(self, dt, in, out);
                return;
            }
            self->state = RETURN;
            start_circle(self);
            break;
        case RETURN:
            if (!comes_near(self, distance(in, self->began))) {
                circle(self, dt, in, out);
                return;
            }
            self->state = NEAREST;
            start_circle(self);
            break;
        case NEAREST:
            if (!comes_near(self, distance(in, self->nearest))) {
                circle(self, dt, in, out);
                return;
            }
            if (self->nearest_distance < self->began_distance - 0.2) {
                self->state = DRIVE;
                self->near_before = false;
            } else {
                rest(self, failed_ns);
            }
            break;
        default: /* REST */
            if (self->since_ns < self->rest_ns) {
                out->v = 0.0;
                out->omega = 0.0;
                return;
            }
            self->state = DRIVE;
            self->near_before = false;
            break;
        }
        dt = 0.0;
    }
}

void by_hand_step_in_seconds(struct by_hand *self, double dt, const struct bug_input *in,
                             struct bug_output *out)
{
    const int64_t ns = self->started ? nanoseconds(dt) : 0;
    self->started = true;
    by_hand_step(self, ns, (double)ns / 1e9, in, out);
}
