#include "device.h"

#include <frob/ros.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "acceptance.h"
#include "dials.h"
#include "hosts/robot/line.h"
#include "readings.h"

/* Robot bases stop if they do not receive a command for some time, often half a second. Therefore
 * the driver repeats the last command after this time. */
#define REPEAT_NS INT64_C(100000000)

/* A robot that is slower than this is considered to be standing still. */
static const double stands_m_s = 0.01, stands_rad_s = 0.02;

static const struct frob_setting settings[ROS_SETTINGS] = {
    { "late", 0.2, 0.01, 10.0, "maximum delay of an accepted message, s" },
    { "lidar_x", (double)NAN, -10.0, 10.0,
      "position of the lidar ahead of the robot's centre, used instead of /tf, m" },
    { "lidar_y", (double)NAN, -10.0, 10.0,
      "position of the lidar to the left of the robot's centre, m" },
    { "lidar_heading", (double)NAN, -7.0, 7.0,
      "direction of the lidar, positive to the left, rad" },
    { "imu_aligned", 0.0, 0.0, 1.0,
      "1: the axes of inertial units match the robot's; otherwise /tf is read" },
    { "sim_time", 0.0, 0.0, 1.0, "1: instants follow the time of /clock, as with use_sim_time" },
    { "instants", 1.0, 0.0, 1.0, "0: do not publish ~/instants, which are needed to replay a bag" },
    { "lifecycle", 0.0, 0.0, 1.0, "1: be a managed node, as with --lifecycle" },
    { "fastest", 1.0, 0.01, 10.0, "maximum speed that is published, m/s" },
    { "fastest_turn", 3.0, 0.01, 20.0, "maximum turn rate that is published, rad/s" },
    { "stamped", 0.0, 0.0, 1.0, "1: publish TwistStamped instead of Twist" },
    { "markers", 1.0, 0.0, 1.0, "0: do not publish the program's drawing on ~/markers" },
};

static const size_t drives[] = { offsetof(struct frob_ros_output, forward),
                                 offsetof(struct frob_ros_output, turn) };

static double most(const void *device, size_t i)
{
    const struct ros_device *d = (const struct ros_device *)device;
    const double *values = d->settings;
    return values == NULL ? settings[i].initial : values[i == 0 ? ROS_FASTEST : ROS_FASTEST_TURN];
}

static void start(void *device, const double *values, const struct frob_serial *serial,
                  const struct frob_clock *clock)
{
    struct ros_device *d = (struct ros_device *)device;
    const struct ros_motion motion = d->motion;
    const struct sim_clock sim_clock = d->sim_clock;
    const uint32_t resets = d->managed.resets;
    const bool drove = d->drove, gave = d->gave;
    const double battery_v = gave ? d->battery_v : (double)NAN;
    memset(d, 0, sizeof *d);
    d->motion = motion;
    d->sim_clock = sim_clock;
    d->managed.resets = resets;
    d->managed.is_active = values[ROS_LIFECYCLE] <= 0.0;
    d->battery_v = battery_v;
    d->drove = drove;
    d->gave = gave;
    d->settings = values;
    d->serial = *serial;
    d->clock = *clock;
    d->sensed_ns = d->odometry.received_ns = INT64_MIN;
    operated_start(&d->operated);
}

/* ---- Messages from the node */

static void take_odometry(struct ros_device *d, const struct ros_odometry *odometry)
{
    struct ros_motion motion;
    const char *bad = ros_motion_of(odometry, &motion);
    if (ros_accepts(d, &d->odometry, bad, odometry->stamp_ns, odometry->arrived_ns, &d->sensed_ns))
        d->motion = motion;
}

/* ---- Time */

static double s(int64_t ns)
{
    return (double)ns * 1e-9;
}

static void take_clock(struct ros_device *d, const struct ros_clock *clock)
{
    const int64_t jump_ns = sim_clock_take(&d->sim_clock, clock->time_ns);
    if (jump_ns != 0) {
        fprintf(stderr,
                "warning: the time of /clock jumped %s by %.3f s; the program continues at its own "
                "time\n",
                jump_ns < 0 ? "back" : "ahead", s(jump_ns < 0 ? -jump_ns : jump_ns));
        /* The timestamps of messages jump, too. */
        memset(&d->odometry.stamps, 0, sizeof d->odometry.stamps);
        for (size_t i = 0; i < ROS_SENSORS_MOST; i++)
            memset(&d->sensors[i].topic.stamps, 0, sizeof d->sensors[i].topic.stamps);
    }
}

int64_t ros_device_time_ns(const void *device, int64_t now_ns)
{
    const struct ros_device *d = (const struct ros_device *)device;
    if (!ros_has_sim_time(d))
        return now_ns;
    return d->sim_clock.started ? sim_clock_now_ns(&d->sim_clock) : INT64_MIN;
}

/* ---- Managed nodes */

static void take_state(struct ros_device *d, const struct ros_state *state)
{
    d->managed.is_active = state->is_active;
    d->managed.is_final = state->is_final;
    d->managed.resets += state->resets ? 1 : 0;
}

struct line_orders ros_device_orders(const void *device)
{
    const struct ros_managed *managed = &((const struct ros_device *)device)->managed;
    const struct line_orders orders = { !managed->is_active, managed->is_final, managed->resets };
    return orders;
}

void ros_device_give(void *device, const struct frob_program *program, void *input, int64_t now_ns)
{
    struct ros_device *d = (struct ros_device *)device;
    ros_give_dials(d, program, input);
    ros_give_readings(d, program, input, now_ns);
    operated_give(&d->operated, input, now_ns);
}

static void take(struct ros_device *d)
{
    switch (d->message.head.kind) {
    case ROS_STARTED:
        d->started = d->message.started;
        snprintf(d->odometry.name, sizeof d->odometry.name, "%s", d->started.odometry);
        operated_name(&d->operated, &d->started);
        break;
    case ROS_ODOMETRY: take_odometry(d, &d->message.odometry); break;
    case ROS_SCAN: ros_take_scan(d, &d->message.scan); break;
    case ROS_IMU: ros_take_imu(d, &d->message.imu); break;
    case ROS_CLOCK: take_clock(d, &d->message.clock); break;
    case ROS_TOUCH: ros_take_touch(d, &d->message.touch); break;
    case ROS_BUMPER: ros_take_bumper(d, &d->message.bumper); break;
    case ROS_JOY: operated_take_joy(d, &d->message.joy); break;
    case ROS_PRESS: operated_take_press(d, &d->message.press); break;
    case ROS_CLICK: operated_take_click(d, &d->message.click); break;
    case ROS_BATTERY: d->battery_v = d->message.battery.voltage_v; break;
    case ROS_STATE: take_state(d, &d->message.state); break;
    default:
        if (d->take_other != NULL)
            d->take_other(d, &d->message.head);
        break;
    }
}

/* Handles the complete messages that have been received, and keeps an incomplete one for later.
 * Returns false if the bytes are not messages. */
static bool take_all(struct ros_device *d)
{
    while (d->have >= sizeof d->message.head) {
        const size_t size = d->message.head.size;
        if (size < sizeof d->message.head || size > sizeof d->message)
            return false;
        if (d->have < size)
            return true;
        take(d);
        d->have -= size;
        memmove(d->message.bytes, d->message.bytes + size, d->have);
    }
    return true;
}

static enum frob_status read_all(struct ros_device *d)
{
    /* The limit is more than can arrive between two polls. It ends the loop even if messages keep
     * arriving. */
    for (int i = 0; i < 64; i++) {
        size_t count;
        enum frob_status status = d->serial.operations->read(
            d->serial.port, d->message.bytes + d->have, sizeof d->message - d->have, &count);
        if (status != FROB_OK || count == 0)
            return status;
        d->have += count;
        if (!take_all(d))
            return FROB_LOST;
    }
    return FROB_OK;
}

/* ---- Messages to the node */

static enum frob_status publish(struct ros_device *d)
{
    d->sent_ns = frob_now_ns(&d->clock);
    return d->serial.operations->write(d->serial.port, (const uint8_t *)&d->velocity,
                                       sizeof d->velocity);
}

static enum frob_status publish_velocity(struct ros_device *d, double speed_m_s, double turn_rad_s)
{
    d->velocity.head.size = (uint32_t)sizeof d->velocity;
    d->velocity.head.kind = ROS_VELOCITY;
    d->velocity.speed_m_s = speed_m_s;
    d->velocity.turn_rad_s = turn_rad_s;
    return publish(d);
}

static enum frob_status command(void *device, const void *output)
{
    struct ros_device *d = (struct ros_device *)device;
    const struct frob_ros_output *o = (const struct frob_ros_output *)output;
    d->commanded = d->drove = true;
    return publish_velocity(d, o->forward, o->turn);
}

static enum frob_status stop(void *device)
{
    struct ros_device *d = (struct ros_device *)device;
    d->commanded = false;
    return publish_velocity(d, 0.0, 0.0);
}

static void close_session(void *device)
{
    stop(device);
}

/* ---- The rest of the table */

static void tell_silences(struct ros_device *d)
{
    ros_tell_silence(d, &d->odometry, "; the robot stands still until one arrives");
    for (size_t i = 0; i < ROS_SENSORS_MOST; i++)
        if (d->sensors[i].used)
            ros_tell_silence(d, &d->sensors[i].topic, "");
}

static enum frob_status poll_device(void *device)
{
    struct ros_device *d = (struct ros_device *)device;
    enum frob_status status = read_all(d);
    const bool due = frob_now_ns(&d->clock) >= d->sent_ns + REPEAT_NS;
    const bool connecting = d->sensed_ns == INT64_MIN;
    if (status == FROB_OK)
        tell_silences(d);
    if (status == FROB_OK && due && d->commanded)
        status = publish(d);
    /* An earlier session may have left the robot moving. */
    if (status == FROB_OK && due && connecting && d->drove)
        status = stop(d);
    if (status != FROB_OK)
        return status;
    return connecting ? FROB_BUSY_CONNECTING : FROB_OK;
}

static int64_t due_ns(const void *device)
{
    const struct ros_device *d = (const struct ros_device *)device;
    const bool repeats = d->commanded || (d->drove && d->sensed_ns == INT64_MIN);
    return repeats ? d->sent_ns + REPEAT_NS : INT64_MAX;
}

static int64_t sensed_ns(const void *device)
{
    const struct ros_device *d = (const struct ros_device *)device;
    return ros_placed_ns(d, d->sensed_ns);
}

static void sense(void *device, void *input)
{
    const struct ros_device *d = (const struct ros_device *)device;
    struct frob_ros_input *i = (struct frob_ros_input *)input;
    i->odometry.position.x = d->motion.x_m;
    i->odometry.position.y = d->motion.y_m;
    i->odometry.heading = d->motion.heading_rad;
    i->speed = d->motion.speed_m_s;
    i->turning = d->motion.turning_rad_s;
    i->battery = d->battery_v;
}

static const char *describe(const void *device)
{
    const struct ros_device *d = (const struct ros_device *)device;
    static char text[3 * ROS_NAME + 64];
    if (d->started.node[0] == '\0')
        return "";
    snprintf(text, sizeof text, "node %s, odometry from %s, velocity to %s", d->started.node,
             d->started.odometry, d->started.velocity);
    return text;
}

static bool stands(const void *device)
{
    const struct ros_device *d = (const struct ros_device *)device;
    return fabs(d->motion.speed_m_s) < stands_m_s && fabs(d->motion.turning_rad_s) < stands_rad_s;
}

const struct frob_driver frob_ros_driver = {
    .robot = "ros",
    .rate = 0,
    .device_size = sizeof(struct ros_device),
    .input_size = sizeof(struct frob_ros_input),
    .output_size = sizeof(struct frob_ros_output),
    .settings = settings,
    .setting_count = ROS_SETTINGS,
    .drives = drives,
    .drive_count = sizeof drives / sizeof drives[0],
    .most = most,
    .start = start,
    .poll = poll_device,
    .due_ns = due_ns,
    .sensed_ns = sensed_ns,
    .sense = sense,
    .command = command,
    .stop = stop,
    .close = close_session,
    .describe = describe,
    .stands = stands,
};
