#include "device.h"

#include <frob/console.h>
#include <frob/ros.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "hosts/robot/line.h"

/* Robot bases stop if they do not receive a command for some time, often half a second. Therefore
 * the driver repeats the last command after this time. */
#define REPEAT_NS INT64_C(100000000)

/* After this time without messages, the driver reports the silence. */
#define SILENCE_NS INT64_C(1000000000)

/* Time to wait for the transforms of a lidar's frame before reporting that there are none. */
#define FRAMES_NS INT64_C(3000000000)

/* A robot that is slower than this is considered to stand still. */
static const double stands_m_s = 0.01, stands_rad_s = 0.02;

static const struct frob_setting settings[ROS_SETTINGS] = {
    { "late", 0.2, 0.01, 10.0, "maximum delay of a message that counts, s" },
    { "lidar_x", (double)NAN, -10.0, 10.0,
      "position of the lidar ahead of the robot's centre, instead of reading /tf, m" },
    { "lidar_y", (double)NAN, -10.0, 10.0, "position of the lidar to the left, m" },
    { "lidar_heading", (double)NAN, -7.0, 7.0,
      "direction of the lidar, positive to the left, rad" },
    { "sim_time", 0.0, 0.0, 1.0, "1: instants follow the time of /clock, as with use_sim_time" },
    { "instants", 1.0, 0.0, 1.0, "0: do not publish ~/instants, with which a bag is replayed" },
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

static double s(int64_t ns)
{
    return (double)ns * 1e-9;
}

/* Reports a message with an implausible timestamp. Each kind of fault is reported once, until the
 * clock is set. */
static void tell_stamp(struct ros_topic *topic, enum stamps_verdict verdict, int64_t by_ns)
{
    if (verdict == STAMPS_GOOD || topic->told[verdict])
        return;
    topic->told[verdict] = true;
    switch (verdict) {
    case STAMPS_OLD:
        fprintf(stderr, "warning: a message on %s arrived %.3f s late; late messages are ignored\n",
                topic->name, s(by_ns));
        break;
    case STAMPS_BACK:
    case STAMPS_AHEAD:
        fprintf(stderr,
                "warning: the stamp of a message on %s jumped %s by %.3f s; messages are ignored "
                "until stamps have been regular for a second\n",
                topic->name, verdict == STAMPS_BACK ? "back" : "ahead", s(by_ns));
        break;
    case STAMPS_RESET:
        fprintf(stderr, "warning: the clock of the messages on %s was set; they count again\n",
                topic->name);
        memset(topic->told, 0, sizeof topic->told);
        break;
    case STAMPS_GOOD: break;
    }
}

void ros_device_tell_silence(const struct ros_device *d, struct ros_topic *topic,
                             const char *effect)
{
    const int64_t now = frob_now_ns(&d->clock);
    if (topic->received_ns == INT64_MIN || topic->told_silence ||
        now - topic->received_ns < SILENCE_NS)
        return;
    topic->told_silence = true;
    fprintf(stderr, "warning: no message on %s for %.0f s%s\n", topic->name, s(SILENCE_NS), effect);
}

static bool has_sim_time(const struct ros_device *d)
{
    return d->settings[ROS_SIM_TIME] > 0.0;
}

bool ros_device_accepts(struct ros_device *d, struct ros_topic *topic, const char *bad,
                        int64_t stamp_ns, int64_t arrived_ns, int64_t *taken_ns)
{
    const int64_t late_ns = (int64_t)(d->settings[ROS_LATE] * 1e9);
    enum stamps_verdict verdict;
    int64_t by_ns, clock_ns = arrived_ns;
    topic->received_ns = frob_now_ns(&d->clock);
    topic->told_silence = false;
    if (bad != NULL) {
        if (topic->told_bad != bad)
            fprintf(stderr, "warning: a message on %s is ignored: %s\n", topic->name, bad);
        topic->told_bad = bad;
        return false;
    }
    /* A simulator's time may run slower than ours, or not at all. */
    if (has_sim_time(d) && !d->sim_clock.started)
        return false;
    if (has_sim_time(d))
        clock_ns = d->sim_clock.time_ns;
    verdict = stamps_judge(&topic->stamps, stamp_ns, clock_ns, late_ns, &by_ns);
    tell_stamp(topic, verdict, by_ns);
    if (verdict != STAMPS_GOOD && verdict != STAMPS_RESET)
        return false;
    *taken_ns = arrived_ns - (verdict == STAMPS_GOOD ? by_ns : 0);
    return true;
}

static void take_odometry(struct ros_device *d, const struct ros_odometry *odometry)
{
    struct ros_motion motion;
    const char *bad = ros_motion_of(odometry, &motion);
    if (ros_device_accepts(d, &d->odometry, bad, odometry->stamp_ns, odometry->arrived_ns,
                           &d->sensed_ns))
        d->motion = motion;
}

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

void ros_device_explain(const struct ros_placing *placing, const char *effect, const char *how,
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

/* Determines the place of a lidar from the settings, if there are any, and otherwise from the
 * transforms. Returns NULL, or the reason why the place is not known. */
static const char *seat_of(const struct ros_device *d, struct ros_sensor *sensor,
                           const struct ros_scan *message, struct ros_seat *seat)
{
    static const char stands[] = ", and the robot stands",
                      how[] = "set the place of the lidar with `--set lidar_x=...`, `lidar_y` and "
                              "`lidar_heading`";
    const double *chosen = d->settings;
    seat->x_m = or_zero(chosen[ROS_LIDAR_X]);
    seat->y_m = or_zero(chosen[ROS_LIDAR_Y]);
    seat->heading_rad = or_zero(chosen[ROS_LIDAR_HEADING]);
    seat->is_upside_down = false;
    if (!isnan(chosen[ROS_LIDAR_X]) || !isnan(chosen[ROS_LIDAR_Y]) ||
        !isnan(chosen[ROS_LIDAR_HEADING]))
        return NULL;
    if (message->placing.fate != ROS_FOUND)
        ros_device_explain(&message->placing, stands, how, sensor->why, sizeof sensor->why);
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

int64_t ros_device_placed_ns(const struct ros_device *d, int64_t sensed_ns)
{
    for (size_t i = 0; i < ROS_SENSORS_MOST; i++)
        if (d->sensors[i].used && d->sensors[i].lost_ns < sensed_ns)
            sensed_ns = d->sensors[i].lost_ns;
    return sensed_ns;
}

static void take_scan(struct ros_device *d, const struct ros_scan *message)
{
    struct ros_sensor *sensor = sensor_of(d, ROS_SCAN, &message->origin);
    const int64_t now = frob_now_ns(&d->clock);
    struct ros_seat seat;
    const char *bad;
    if (sensor == NULL)
        return;
    bad = seat_of(d, sensor, message, &seat);
    if (bad == NULL)
        sensor->lost_ns = INT64_MAX;
    else if (sensor->lost_ns == INT64_MAX)
        sensor->lost_ns = now;
    /* When a node starts, the transforms may arrive after the scans. */
    if (message->placing.fate == ROS_NOT_FOUND && bad != NULL && now - sensor->lost_ns < FRAMES_NS)
        return;
    if (bad == NULL)
        bad = ros_scan_of(message, &seat, sensor->ranges_m, &sensor->scan);
    if (bad == NULL)
        sensor->number++;
    sensor->fresh = ros_device_accepts(d, &sensor->topic, bad, message->origin.stamp_ns,
                                       message->origin.arrived_ns, &sensor->taken_ns);
}

static void take_imu(struct ros_device *d, const struct ros_imu *message)
{
    struct ros_sensor *sensor = sensor_of(d, ROS_IMU, &message->origin);
    const char *bad;
    if (sensor == NULL)
        return;
    bad = ros_imu_check(message);
    if (!ros_device_accepts(d, &sensor->topic, bad, message->origin.stamp_ns,
                            message->origin.arrived_ns, &sensor->taken_ns))
        return;
    ros_imu_add(&sensor->sums, message);
    sensor->fresh = true;
}

/* A robot may publish a bumper only when it changes, so silence is normal. */
static void take_bumper(struct ros_device *d, const struct ros_bumper *message)
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

/* ---- Time */

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
    if (!has_sim_time(d))
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

/* ---- The console */

/* Handles a parameter of the node that was set. After a restart of the node, the program's values
 * apply. */
static void take_touch(struct ros_device *d, const struct ros_touch *touch)
{
    struct ros_dial *dial;
    if (touch->control >= ROS_CONTROLS_MOST || (touch->is_initial && d->gave))
        return;
    dial = &d->dials[touch->control];
    dial->value = touch->value;
    dial->is_set = dial->is_known = true;
}

static double dial_value(const struct frob_control *control, const void *input)
{
    const char *at = (const char *)input + control->value->offset;
    double number;
    float single;
    bool truth;
    if (control->kind == FROB_TOGGLE) {
        memcpy(&truth, at, sizeof truth);
        return truth ? 1.0 : 0.0;
    }
    if (control->value->kind == FROB_SINGLE) {
        memcpy(&single, at, sizeof single);
        return (double)single;
    }
    memcpy(&number, at, sizeof number);
    return number;
}

static void tell_node(const struct ros_device *d, size_t control, double value)
{
    struct ros_touch touch;
    memset(&touch, 0, sizeof touch);
    touch.head.size = (uint32_t)sizeof touch;
    touch.head.kind = ROS_TOUCH;
    touch.control = (uint32_t)control;
    touch.value = value;
    /* If the line is lost, poll detects it. */
    d->serial.operations->write(d->serial.port, (const uint8_t *)&touch, sizeof touch);
}

/* Applies the values of knobs and toggles that other nodes have set, and sends the node the values
 * that were set here. */
static void give_dials(struct ros_device *d, const struct frob_program *program, void *input)
{
    for (size_t i = 0; i < program->control_count && i < ROS_CONTROLS_MOST; i++) {
        const struct frob_control *control = &program->console[i];
        struct ros_dial *dial = &d->dials[i];
        double value;
        if (control->kind != FROB_KNOB && control->kind != FROB_TOGGLE)
            continue;
        if (dial->is_set)
            frob_console_touch(program, input, i, dial->value, 0.0);
        value = dial_value(control, input);
        if (!dial->is_set && (!dial->is_known || value < dial->value || value > dial->value))
            tell_node(d, i, value);
        dial->is_set = false;
        dial->is_known = true;
        dial->value = value;
    }
    d->gave = true;
}

void ros_device_give(void *device, const struct frob_program *program, void *input, int64_t now_ns)
{
    struct ros_device *d = (struct ros_device *)device;
    give_dials(d, program, input);
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
    operated_give(&d->operated, input, now_ns);
    for (size_t k = 0; k < ROS_SENSORS_MOST; k++) {
        if (d->sensors[k].fresh)
            ros_imu_restart(&d->sensors[k].sums);
        d->sensors[k].fresh = false;
    }
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
    case ROS_SCAN: take_scan(d, &d->message.scan); break;
    case ROS_IMU: take_imu(d, &d->message.imu); break;
    case ROS_CLOCK: take_clock(d, &d->message.clock); break;
    case ROS_TOUCH: take_touch(d, &d->message.touch); break;
    case ROS_BUMPER: take_bumper(d, &d->message.bumper); break;
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

/* Handles the messages that have been received, and keeps an incomplete one for later. Returns
 * false if the bytes are not messages. */
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
    /* Reads more than can arrive between two polls, but stops even if messages keep arriving. */
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
    ros_device_tell_silence(d, &d->odometry, "; the robot stands until one arrives");
    for (size_t i = 0; i < ROS_SENSORS_MOST; i++)
        if (d->sensors[i].used)
            ros_device_tell_silence(d, &d->sensors[i].topic, "");
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
    return ros_device_placed_ns(d, d->sensed_ns);
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
