#include "wall_follow_by_hand.h"

#include <math.h>

static const double distance = 0.2;
static const double v_max = 0.4;
static const double theta_max = 20 * 3.14159265358979323846 / 180;
static const double k_front = 1.0, k_side = 0.8, k_turn = 3.0;

static double limit(double x, double y)
{
    if (y > x)
        return x;
    if (y < -x)
        return -x;
    return y;
}

void wall_follow_by_hand_reset(struct wall_follow_by_hand *self)
{
    self->sin_theta_max = sin(theta_max);
    self->s_before = 0.0;
    self->s_dot = 0.0;
    self->started = false;
}

void wall_follow_by_hand_step(struct wall_follow_by_hand *self, double dt, double v_curr,
                              double f, double s, double *v, double *omega)
{
    if (!self->started)
        self->started = true;
    else if (dt > 0)
        self->s_dot = (s - self->s_before) / dt;
    self->s_before = s;
    *v = limit(v_max, k_front * (f - distance));
    *omega = k_turn * (limit(self->sin_theta_max * v_curr, k_side * (s - distance)) - self->s_dot);
}
