#include "drivers/create/odometry.h"

#include <math.h>
#include <stdlib.h>

/* A wheel's maximum speed is 0.5 m/s, which is 1125 counts per second. The limit is somewhat
 * higher, and allows 64 more counts for late frames. */
#define BELIEVED_COUNTS_PER_S 1500
#define BELIEVED_COUNTS 64
#define MOST_REFUSED 3
#define MEASURE_NS INT64_C(60000000)

void frob_create_odometry_reconnect(struct frob_create_odometry *o)
{
    o->known = false;
    o->refused = 0;
    o->left_m = o->right_m = 0.0;
    o->left_m_s = o->right_m_s = 0.0;
}

static void move(struct frob_create_odometry *o, int left, int right, double separation_m)
{
    double left_m = left * FROB_CREATE_METRES_PER_COUNT;
    double right_m = right * FROB_CREATE_METRES_PER_COUNT;
    double way = 0.5 * (left_m + right_m), turned = (right_m - left_m) / separation_m;
    /* The motion is along an arc, so this adds the arc's chord, in the mean direction. */
    double chord = fabs(turned) < 1e-6 ? way : way * sin(0.5 * turned) / (0.5 * turned);
    o->x_m += chord * cos(o->heading_rad + 0.5 * turned);
    o->y_m += chord * sin(o->heading_rad + 0.5 * turned);
    o->heading_rad += turned;
    o->left_m += left_m;
    o->right_m += right_m;
}

static void measure(struct frob_create_odometry *o, int64_t now_ns)
{
    double elapsed_s = (double)(now_ns - o->measured_ns) * 1e-9;
    if (now_ns - o->measured_ns < MEASURE_NS)
        return;
    o->left_m_s = o->left_m / elapsed_s;
    o->right_m_s = o->right_m / elapsed_s;
    o->left_m = 0.0;
    o->right_m = 0.0;
    o->measured_ns = now_ns;
}

bool frob_create_odometry_add(struct frob_create_odometry *o, uint16_t left_counts,
                              uint16_t right_counts, int64_t now_ns, double separation_m)
{
    if (o->known) {
        int left = frob_create_count_step(o->left_counts, left_counts);
        int right = frob_create_count_step(o->right_counts, right_counts);
        int64_t believed =
            BELIEVED_COUNTS + BELIEVED_COUNTS_PER_S * ((now_ns - o->taken_ns) / 1000) / 1000000;
        bool reachable = abs(left) <= believed && abs(right) <= believed;
        if (!reachable && o->refused < MOST_REFUSED) {
            o->refused++;
            return false;
        }
        if (reachable)
            move(o, left, right, separation_m);
        measure(o, now_ns);
    } else {
        o->known = true;
        o->measured_ns = now_ns;
    }
    o->refused = 0;
    o->left_counts = left_counts;
    o->right_counts = right_counts;
    o->taken_ns = now_ns;
    return true;
}
