/* Converts a SIP to the robot's sensor readings. */
#include "drivers/pioneer/device.h"

#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846

/* Maximum time for which odometry is extrapolated from the speeds in a SIP. */
#define CARRIED_MOST_S 0.2

/* Returns the difference between two values of a 15-bit counter, modulo 2^15. If the jump is larger
 * than a robot can travel between two SIPs, the counter was reset, and the result is 0. */
static int32_t counted(uint16_t from, uint16_t to)
{
    int32_t way = (int32_t)((uint32_t)(to - from) & 0x7FFFu);
    if (way >= 0x4000)
        way -= 0x8000;
    return way > 0x1000 || way < -0x1000 ? 0 : way;
}

/* Reduces an angle to the range -pi < angle <= pi. */
static double wrapped(double angle)
{
    angle = fmod(angle, 2.0 * PI);
    if (angle > PI)
        angle -= 2.0 * PI;
    if (angle <= -PI)
        angle += 2.0 * PI;
    return angle;
}

/* When a session begins, odometry continues from its last pose, because the robot's own counters
 * may start at any position and heading. */
static void take_position(struct frob_pioneer *d, const struct frob_p2os_sip *sip)
{
    double heading = d->model.angle * sip->heading;
    if (!d->has_counters) {
        d->turned_rad = d->odometry.heading - heading;
        d->has_counters = true;
    } else {
        double dx = counted(d->x, sip->x) * d->model.distance / 1000.0;
        double dy = counted(d->y, sip->y) * d->model.distance / 1000.0;
        double c = cos(d->turned_rad), s = sin(d->turned_rad);
        d->odometry.position.x += c * dx - s * dy;
        d->odometry.position.y += s * dx + c * dy;
    }
    d->x = sip->x;
    d->y = sip->y;
    d->odometry.heading = wrapped(heading + d->turned_rad);
}

void frob_pioneer_take_sip(struct frob_pioneer *d, const struct frob_p2os_sip *sip)
{
    d->sensed_ns = frob_now_ns(&d->clock);
    d->sip = *sip;
    take_position(d, sip);
    for (size_t i = 0; i < sip->echo_count; i++) {
        size_t transducer = sip->echoes[i].transducer;
        if (transducer < FROB_PIONEER_SONARS) {
            struct frob_pioneer_sonar *sonar = &d->sonar[transducer];
            sonar->range_m = sip->echoes[i].range * d->model.range / 1000.0;
            sonar->heard_ns = d->sensed_ns;
            sonar->fresh = true;
        }
    }
}

/* Extrapolates the pose to the current time. Packets arrive only ten times a second. Without
 * extrapolation, a program with more frequent steps would see the robot stop and jump. With the
 * wheels' speeds v_left and v_right, in the time t since the packet, the distance and the angle are
 *   d = t (v_right + v_left) / 2,   a = t difference (v_right - v_left) / 2,
 * and the robot moves d along the heading that it has halfway through the turn. The next
 * packet replaces the estimate. */
static struct frob_pose carried_on(const struct frob_pioneer *d)
{
    struct frob_pose pose = d->odometry;
    double left = d->sip.left * d->model.speed, right = d->sip.right * d->model.speed; /* mm/s */
    double t = (double)(frob_now_ns(&d->clock) - d->sensed_ns) / 1e9;
    double way, angle;
    if (d->settings[FROB_PIONEER_CARRY_ON] == 0.0)
        return pose;
    if (t > CARRIED_MOST_S)
        t = CARRIED_MOST_S;
    way = t * (right + left) / 2.0 / 1000.0;
    angle = t * d->model.difference * (right - left) / 2.0;
    pose.position.x += way * cos(pose.heading + angle / 2.0);
    pose.position.y += way * sin(pose.heading + angle / 2.0);
    pose.heading = wrapped(pose.heading + angle);
    return pose;
}

void frob_pioneer_sense(void *device, void *input)
{
    struct frob_pioneer *d = (struct frob_pioneer *)device;
    struct frob_pioneer_input *in = (struct frob_pioneer_input *)input;
    const struct frob_p2os_sip *sip = &d->sip;
    memset(in, 0, sizeof *in);
    in->odometry = carried_on(d);
    in->leftWheel = sip->left * d->model.speed / 1000.0;
    in->rightWheel = sip->right * d->model.speed / 1000.0;
    for (size_t i = 0; i < FROB_PIONEER_SONARS; i++) {
        struct frob_pioneer_sonar *sonar = &d->sonar[i];
        if (sonar->fresh && sonar->range_m < d->settings[FROB_PIONEER_NO_ECHO]) {
            in->sonar[i].tag = FROB_EVENT_FLOAT_EVENT;
            in->sonar[i].f0 = sonar->range_m;
        }
        sonar->fresh = false;
    }
    in->frontBumper = sip->front_bumpers != 0;
    in->rearBumper = sip->rear_bumpers != 0;
    in->leftStall = sip->left_stall;
    in->rightStall = sip->right_stall;
    in->battery = 0.1 * ((sip->known & FROB_P2OS_KNOWN_BATTERY) != 0 && sip->battery_fine != 0
                             ? sip->battery_fine
                             : sip->battery);
    in->motorsOn = !d->model.has_flags || (sip->flags & FROB_P2OS_FLAG_MOTORS) != 0;
}

bool frob_pioneer_echo(const struct frob_pioneer *d, size_t i, double *range_m, double *age_s)
{
    if (i >= FROB_PIONEER_SONARS || d->sonar[i].heard_ns == INT64_MIN ||
        !(d->sonar[i].range_m < d->settings[FROB_PIONEER_NO_ECHO]))
        return false;
    *range_m = d->sonar[i].range_m;
    *age_s = (double)(frob_now_ns(&d->clock) - d->sonar[i].heard_ns) / 1e9;
    return true;
}
