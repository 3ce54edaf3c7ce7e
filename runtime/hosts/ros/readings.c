#include "readings.h"

#include <frob/console.h>

#include <math.h>
#include <stdio.h>

#include "acceptance.h"
#include "device.h"

/* Time to wait for the transforms of a sensor's frame before reporting that there are none. */
#define FRAMES_NS INT64_C(3000000000)

/* Returns the sensor to which a message belongs; NULL if there is no space for another sensor. */
static struct ros_sensor *sensor_of(struct ros_device *d, enum ros_kind kind,
                                    const struct ros_origin *origin)
{
    for (size_t i = 0; i < ROS_SENSORS_MOST; i++) {
        struct ros_sensor *sensor = &d->sensors[i];
        if (sensor->used && sensor->control == origin->control)
            return sensor;
        if (!sensor->used) {
            sensor->used = true;
            sensor->kind = kind;
            sensor->control = origin->control;
            sensor->topic.received_ns = INT64_MIN;
            sensor->lost_ns = INT64_MAX;
            for (size_t k = 0; k < d->started.sensor_count && k < ROS_SENSORS_MOST; k++)
                if (d->started.sensors[k].control == origin->control)
                    snprintf(sensor->topic.name, sizeof sensor->topic.name, "%s",
                             d->started.sensors[k].topic);
            return sensor;
        }
    }
    return NULL;
}

void ros_explain_frame(const struct ros_placing *placing, const char *effect, const char *how,
                       char *why, size_t room)
{
    if (placing->fate == ROS_NOT_READ)
        snprintf(why, room,
                 "it is in the frame `%s`, and /tf cannot be read, because the package tf2_msgs is "
                 "not installed%s: install it, or %s",
                 placing->frame, effect, how);
    else
        snprintf(why, room,
                 "no transform between its frame `%s` and `%s` is known%s: start the node that "
                 "publishes it on /tf_static or /tf, or %s",
                 placing->frame, placing->in, effect, how);
}

static double or_zero(double setting)
{
    return isnan(setting) ? 0.0 : setting;
}

/* Determines a lidar's position and heading on the robot from the settings, if there are any, and
 * otherwise from the transforms. Returns NULL, or the reason why they are not known. */
static const char *seat_of(const struct ros_device *d, struct ros_sensor *sensor,
                           const struct ros_scan *message, struct ros_seat *seat)
{
    static const char stands[] = ", and the robot stands still",
                      how[] = "set the position of the lidar with `--set lidar_x=...`, `lidar_y` "
                              "and `lidar_heading`";
    const double *chosen = d->settings;
    seat->x_m = or_zero(chosen[ROS_LIDAR_X]);
    seat->y_m = or_zero(chosen[ROS_LIDAR_Y]);
    seat->heading_rad = or_zero(chosen[ROS_LIDAR_HEADING]);
    seat->is_upside_down = false;
    if (!isnan(chosen[ROS_LIDAR_X]) || !isnan(chosen[ROS_LIDAR_Y]) ||
        !isnan(chosen[ROS_LIDAR_HEADING]))
        return NULL;
    if (message->placing.fate != ROS_FOUND)
        ros_explain_frame(&message->placing, stands, how, sensor->why, sizeof sensor->why);
    else if (message->is_tilted)
        snprintf(
            sensor->why, sizeof sensor->why,
            "its frame `%s` is tilted, so its rays are not parallel to the floor%s: correct the "
            "transform, or %s",
            message->placing.frame, stands, how);
    else
        *seat = message->seat;
    return message->placing.fate != ROS_FOUND || message->is_tilted ? sensor->why : NULL;
}

int64_t ros_placed_ns(const struct ros_device *d, int64_t sensed_ns)
{
    for (size_t i = 0; i < ROS_SENSORS_MOST; i++)
        if (d->sensors[i].used && d->sensors[i].kind == ROS_SCAN &&
            d->sensors[i].lost_ns < sensed_ns)
            sensed_ns = d->sensors[i].lost_ns;
    return sensed_ns;
}

/* Records whether a sensor's position on the robot is known. `bad`: the reason why it is unknown,
 * or NULL. Returns whether to wait: when a node starts, the transforms may arrive after the
 * messages. */
static bool waits_for_frame(struct ros_sensor *sensor, const struct ros_placing *placing,
                            const char *bad, int64_t now_ns)
{
    if (bad == NULL)
        sensor->lost_ns = INT64_MAX;
    else if (sensor->lost_ns == INT64_MAX)
        sensor->lost_ns = now_ns;
    return placing->fate == ROS_NOT_FOUND && bad != NULL && now_ns - sensor->lost_ns < FRAMES_NS;
}

void ros_take_scan(struct ros_device *d, const struct ros_scan *message)
{
    struct ros_sensor *sensor = sensor_of(d, ROS_SCAN, &message->origin);
    struct ros_seat seat;
    const char *bad;
    if (sensor == NULL)
        return;
    bad = seat_of(d, sensor, message, &seat);
    if (waits_for_frame(sensor, &message->placing, bad, frob_now_ns(&d->clock)))
        return;
    if (bad == NULL)
        bad = ros_scan_of(message, &seat, sensor->ranges_m, &sensor->scan);
    if (bad == NULL)
        sensor->number++;
    sensor->fresh = ros_accepts(d, &sensor->topic, bad, message->origin.stamp_ns,
                                message->origin.arrived_ns, &sensor->taken_ns);
}

void ros_take_imu(struct ros_device *d, const struct ros_imu *message)
{
    static const char how[] = "add `--set imu_aligned=1` if the unit's axes match the robot's";
    struct ros_sensor *sensor = sensor_of(d, ROS_IMU, &message->origin);
    const bool is_aligned = d->settings[ROS_IMU_ALIGNED] > 0.0;
    struct ros_imu turned = *message;
    const char *bad = NULL;
    if (sensor == NULL)
        return;
    if (!is_aligned && message->placing.fate != ROS_FOUND) {
        ros_explain_frame(&message->placing, "", how, sensor->why, sizeof sensor->why);
        bad = sensor->why;
    }
    if (waits_for_frame(sensor, &message->placing, bad, frob_now_ns(&d->clock)))
        return;
    if (bad == NULL)
        bad = ros_imu_check(message);
    if (!ros_accepts(d, &sensor->topic, bad, message->origin.stamp_ns, message->origin.arrived_ns,
                     &sensor->taken_ns))
        return;
    if (!is_aligned)
        ros_imu_turn(&turned);
    ros_imu_add(&sensor->sums, &turned);
    sensor->fresh = true;
}

/* A robot may publish a bumper's state only when it changes, so silence is normal. */
void ros_take_bumper(struct ros_device *d, const struct ros_bumper *message)
{
    struct ros_sensor *sensor = sensor_of(d, ROS_BUMPER, &message->origin);
    if (sensor != NULL)
        sensor->is_pressed = message->is_pressed;
}

/* Sets the event of one control. Several controls may share a sensor. */
static void give(const struct ros_sensor *sensor, const struct frob_control *control, void *input,
                 int64_t now_ns)
{
    const bool fresh = sensor != NULL && sensor->fresh;
    if (control->kind == FROB_IMU) {
        struct frob_imu reading;
        if (fresh)
            reading = ros_imu_mean(&sensor->sums, sensor->taken_ns);
        frob_imu_give(control, input, fresh ? &reading : NULL, now_ns);
    } else {
        struct frob_scan scan;
        if (fresh) {
            scan = sensor->scan;
            scan.taken_ns = sensor->taken_ns;
            scan.number = sensor->number;
        }
        frob_lidar_give(control, input, fresh ? &scan : NULL, now_ns);
    }
}

void ros_give_readings(struct ros_device *d, const struct frob_program *program, void *input,
                       int64_t now_ns)
{
    for (size_t i = 0; i < program->control_count; i++) {
        const struct frob_control *control = &program->console[i];
        struct ros_sensor *sensor = NULL;
        char name[ROS_NAME];
        if (!ros_topic_of(control, name, sizeof name))
            continue;
        for (size_t k = 0; k < ROS_SENSORS_MOST; k++)
            if (d->sensors[k].used && d->sensors[k].control == ros_first_user(program, i))
                sensor = &d->sensors[k];
        if (control->kind == FROB_HOLD)
            frob_console_touch(program, input, i, sensor != NULL && sensor->is_pressed ? 1.0 : 0.0,
                               0.0);
        else
            give(sensor, control, input, now_ns);
    }
    for (size_t k = 0; k < ROS_SENSORS_MOST; k++) {
        if (d->sensors[k].fresh)
            ros_imu_restart(&d->sensors[k].sums);
        d->sensors[k].fresh = false;
    }
}
