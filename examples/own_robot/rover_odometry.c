#include "rover_odometry.h"

#include <math.h>

/* Limits on plausible counts: twice the motors' top speed, plus a distance for counts that
   arrived late. */
#define BELIEVED_M_S 1.2
#define BELIEVED_M 0.05
#define MOST_REFUSED 3
#define MEASURE_NS INT64_C(100000000)

void rover_odometry_reconnect(struct rover_odometry *o)
{
    o->known = false;
    o->refused = 0;
    o->left_m_s = o->right_m_s = 0.0;
}

/* The distance between two counts, even if the counter wrapped around between them. */
static double way_m(int32_t from, int32_t to, double counts_per_m)
{
    uint32_t step = (uint32_t)to - (uint32_t)from;
    return (step < UINT32_C(0x80000000) ? (double)step : -(double)(0u - step)) / counts_per_m;
}

static void begin(struct rover_odometry *o, int64_t now_ns)
{
    o->known = true;
    o->left_m = o->right_m = 0.0;
    o->left_m_s = o->right_m_s = 0.0;
    o->measured_ns = now_ns;
}

/* Moves the pose along the chord of the arc that the robot has driven. */
static void move(struct rover_odometry *o, double left_m, double right_m, double separation_m)
{
    double way = 0.5 * (left_m + right_m), turn = (right_m - left_m) / separation_m;
    double halfway = o->heading_rad + 0.5 * turn;
    o->x_m += way * cos(halfway);
    o->y_m += way * sin(halfway);
    o->heading_rad += turn;
    o->left_m += left_m;
    o->right_m += right_m;
}

static void measure(struct rover_odometry *o, int64_t now_ns)
{
    double elapsed_s = (double)(now_ns - o->measured_ns) * 1e-9;
    o->left_m_s = o->left_m / elapsed_s;
    o->right_m_s = o->right_m / elapsed_s;
    o->left_m = o->right_m = 0.0;
    o->measured_ns = now_ns;
}

bool rover_odometry_add(struct rover_odometry *o, int32_t left, int32_t right, double counts_per_m,
                        double separation_m, int64_t now_ns)
{
    if (!o->known) {
        begin(o, now_ns);
    } else {
        double left_m = way_m(o->left, left, counts_per_m);
        double right_m = way_m(o->right, right, counts_per_m);
        double believed = BELIEVED_M + BELIEVED_M_S * (double)(now_ns - o->taken_ns) * 1e-9;
        bool reachable = fabs(left_m) <= believed && fabs(right_m) <= believed;
        if (!reachable && o->refused < MOST_REFUSED) {
            o->refused++;
            return false;
        }
        if (reachable)
            move(o, left_m, right_m, separation_m);
        else
            begin(o, now_ns);
        if (now_ns - o->measured_ns >= MEASURE_NS)
            measure(o, now_ns);
    }
    o->refused = 0;
    o->left = left;
    o->right = right;
    o->taken_ns = now_ns;
    return true;
}
