#include "sensors.h"

#include "bumpers.h"
#include "frames.h"
#include "odometry.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double two_pi = 6.28318530717958647692;

/* ---- Lidars */

/* In ROS, minus infinity means that an object is closer than the device can measure. A program sees
 * such an object at the minimum range. */
static double distance(float range, double nearest_m)
{
    return isinf(range) && range < 0.0f ? nearest_m : (double)range;
}

const char *ros_scan_of(const struct ros_scan *m, const struct ros_seat *seat, double *room,
                        struct frob_scan *scan)
{
    const double side = seat->is_upside_down ? -1.0 : 1.0, signed_step = side * m->step_rad;
    const double step = fabs(m->step_rad);
    if (m->count == 0)
        return "it has no ranges";
    if (!isfinite(m->first_rad) || !(step > 0.0) || !isfinite(step))
        return "its angles are not finite numbers, or angle_increment is 0";
    if (step * (m->count - 1) > two_pi * 1.001)
        return "its rays cover more than a full turn";
    if (!isfinite(m->nearest_m) || !isfinite(m->farthest_m) || m->nearest_m < 0.0 ||
        m->nearest_m >= m->farthest_m)
        return "range_min and range_max must be finite, with 0 <= range_min < range_max";
    /* Devices that rotate clockwise, or are upside down, send the rays from left to right. */
    for (uint32_t i = 0; i < m->count; i++)
        room[i] = distance(m->ranges_m[signed_step > 0.0 ? i : m->count - 1 - i], m->nearest_m);
    scan->ranges_m = room;
    scan->count = m->count;
    scan->first_rad = seat->heading_rad + side * m->first_rad;
    if (signed_step < 0.0)
        scan->first_rad += signed_step * (m->count - 1);
    scan->step_rad = step;
    scan->nearest_m = m->nearest_m;
    scan->farthest_m = m->farthest_m;
    scan->x_m = seat->x_m;
    scan->y_m = seat->y_m;
    return NULL;
}

/* ---- Inertial measurement units */

const char *ros_imu_check(const struct ros_imu *m)
{
    double heading_rad;
    for (size_t i = 0; i < 3; i++)
        if (!isfinite(m->rate_radps[i]) || !isfinite(m->acceleration_mps2[i]))
            return "a rate or an acceleration is not a finite number";
    if (m->has_rotation && !ros_yaw_of(m->rotation, &heading_rad))
        return "its orientation is not a quaternion of length 1";
    return NULL;
}

void ros_imu_turn(struct ros_imu *m)
{
    const struct ros_imu own = *m;
    frames_rotate(m->mounting, own.rate_radps, m->rate_radps);
    frames_rotate(m->mounting, own.acceleration_mps2, m->acceleration_mps2);
    frames_orientation(own.rotation, m->mounting, m->rotation);
}

void ros_imu_add(struct ros_measurements *sums, const struct ros_imu *m)
{
    sums->heading_rad = NAN;
    if (m->has_rotation)
        ros_yaw_of(m->rotation, &sums->heading_rad);
    for (size_t i = 0; i < 3; i++) {
        sums->rate_radps[i] += m->rate_radps[i];
        sums->acceleration_mps2[i] += m->acceleration_mps2[i];
    }
    sums->count++;
    sums->number++;
}

struct frob_imu ros_imu_mean(const struct ros_measurements *sums, int64_t taken_ns)
{
    struct frob_imu reading;
    for (size_t i = 0; i < 3; i++) {
        reading.rate_radps[i] = sums->rate_radps[i] / sums->count;
        reading.acceleration_mps2[i] = sums->acceleration_mps2[i] / sums->count;
    }
    reading.heading_rad = sums->heading_rad;
    reading.taken_ns = taken_ns;
    reading.number = sums->number;
    return reading;
}

void ros_imu_restart(struct ros_measurements *sums)
{
    for (size_t i = 0; i < 3; i++)
        sums->rate_radps[i] = sums->acceleration_mps2[i] = 0.0;
    sums->count = 0;
}

/* ---- Names */

/* Returns the length of the sensor's name in the control's label; 0 if the control is not
 * a lidar or an inertial measurement unit. */
static size_t name_length(const struct frob_control *control)
{
    return control->kind == FROB_IMU ? strlen(control->label) : frob_lidar_label(control);
}

bool ros_topic_of(const struct frob_control *control, char *name, size_t room)
{
    const size_t length = name_length(control);
    const char *bumper = bumpers_topic(control);
    if (bumper != NULL) {
        snprintf(name, room, "%s", bumper);
        return true;
    }
    if (length == 0)
        return false;
    snprintf(name, room, "%.*s", (int)length, control->label);
    if (control->kind == FROB_LIDAR && strcmp(name, "lidar") == 0)
        snprintf(name, room, "scan");
    return true;
}

size_t ros_first_user(const struct frob_program *program, size_t i)
{
    const struct frob_control *control = &program->console[i];
    const size_t length = name_length(control);
    size_t k = 0;
    if (length == 0)
        return i;
    while (program->console[k].kind != control->kind ||
           name_length(&program->console[k]) != length ||
           strncmp(program->console[k].label, control->label, length) != 0)
        k++;
    return k;
}
