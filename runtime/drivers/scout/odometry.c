#include "drivers/scout/odometry.h"

#include <math.h>
#include <stdlib.h>

#define INCH_TENTH_M 0.00254
#define DEGREE_TENTH_RAD (3.14159265358979323846 / 1800.0)
/* The robot's maximum speed is 1 m/s, which is 394 units per second. The odometry accepts a
 * somewhat higher speed, plus 12 inches because states may arrive late. After several consecutive
 * rejections, the odometry assumes that the robot was restarted. */
#define BELIEVED_PER_S 600
#define BELIEVED 120
#define MOST_REFUSED 3
#define MEASURE_NS INT64_C(200000000)

void frob_scout_odometry_reconnect(struct frob_scout_odometry *o)
{
    o->known = false;
    o->refused = 0;
    o->forward_m_s = 0.0;
    o->turn_rad_s = 0.0;
}

/* Handles the first state of a connection: the position that the robot reports corresponds to the
 * current pose. */
static void begin(struct frob_scout_odometry *o, const struct frob_scout_state *state,
                  int64_t now_ns)
{
    o->known = true;
    o->axes_rad = o->place.heading_rad - state->heading * DEGREE_TENTH_RAD;
    o->measured = o->place;
    o->measured_ns = now_ns;
}

static bool is_reachable(const struct frob_scout_odometry *o, const struct frob_scout_state *state,
                         int64_t now_ns)
{
    int64_t believed = BELIEVED + BELIEVED_PER_S * ((now_ns - o->taken_ns) / 1000) / 1000000;
    return abs(frob_scout_position_step(o->x, state->x)) <= believed &&
           abs(frob_scout_position_step(o->y, state->y)) <= believed;
}

static void move(struct frob_scout_odometry *o, const struct frob_scout_state *state)
{
    double east = frob_scout_position_step(o->x, state->x) * INCH_TENTH_M;
    double north = frob_scout_position_step(o->y, state->y) * INCH_TENTH_M;
    double c = cos(o->axes_rad), s = sin(o->axes_rad);
    o->place.x_m += c * east - s * north;
    o->place.y_m += s * east + c * north;
    o->place.heading_rad += frob_scout_heading_step(o->heading, state->heading) * DEGREE_TENTH_RAD;
}

/* Computes speeds from the distance since the last measurement, along the mean heading. */
static void measure(struct frob_scout_odometry *o, int64_t now_ns)
{
    double elapsed_s = (double)(now_ns - o->measured_ns) * 1e-9;
    double halfway = 0.5 * (o->measured.heading_rad + o->place.heading_rad);
    double dx = o->place.x_m - o->measured.x_m, dy = o->place.y_m - o->measured.y_m;
    o->forward_m_s = (dx * cos(halfway) + dy * sin(halfway)) / elapsed_s;
    o->turn_rad_s = (o->place.heading_rad - o->measured.heading_rad) / elapsed_s;
    o->measured = o->place;
    o->measured_ns = now_ns;
}

bool frob_scout_odometry_add(struct frob_scout_odometry *o, const struct frob_scout_state *state,
                             int64_t now_ns)
{
    if (o->known) {
        bool reachable = is_reachable(o, state, now_ns);
        if (!reachable && o->refused < MOST_REFUSED) {
            o->refused++;
            return false;
        }
        if (reachable)
            move(o, state);
        else
            begin(o, state, now_ns);
        if (now_ns - o->measured_ns >= MEASURE_NS)
            measure(o, now_ns);
    } else {
        begin(o, state, now_ns);
    }
    o->refused = 0;
    o->x = state->x;
    o->y = state->y;
    o->heading = state->heading;
    o->taken_ns = now_ns;
    return true;
}
