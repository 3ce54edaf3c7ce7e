#include "device.h"

#include <frob/ros.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The bases of robots stop if they hear nothing for some time, often half a second. */
#define REPEAT_NS INT64_C(100000000)

/* Without messages for this time, the silence is reported. */
#define SILENCE_NS INT64_C(1000000000)

/* Slower than this, the robot stands. */
static const double stands_m_s = 0.01, stands_rad_s = 0.02;

static const struct frob_setting settings[ROS_SETTINGS] = {
    { "fastest", 1.0, 0.01, 10.0, "maximum speed that is published, m/s" },
    { "fastest_turn", 3.0, 0.01, 20.0, "maximum turn rate that is published, rad/s" },
    { "late", 0.2, 0.01, 10.0, "maximum delay of a message that counts, s" },
    { "stamped", 0.0, 0.0, 1.0, "1: publish TwistStamped instead of Twist" },
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
    const bool drove = d->drove;
    memset(d, 0, sizeof *d);
    d->motion = motion;
    d->drove = drove;
    d->settings = values;
    d->serial = *serial;
    d->clock = *clock;
    d->sensed_ns = d->received_ns = INT64_MIN;
}

/* ---- Messages from the node */

static double s(int64_t ns)
{
    return (double)ns * 1e-9;
}

/* Reports a message with a strange stamp, once for each kind of fault until the clock is set. */
static void tell_stamp(struct ros_device *d, enum stamps_verdict verdict, int64_t by_ns)
{
    const char *topic = d->started.odometry;
    if (verdict == STAMPS_GOOD || d->told[verdict])
        return;
    d->told[verdict] = true;
    switch (verdict) {
    case STAMPS_OLD:
        fprintf(stderr,
                "warning: a message on %s arrived %.3f s late; late messages do not count, and the "
                "robot stands until messages arrive in time\n",
                topic, s(by_ns));
        break;
    case STAMPS_BACK:
    case STAMPS_AHEAD:
        fprintf(stderr,
                "warning: the stamp of a message on %s jumped %s by %.3f s; the robot stands until "
                "stamps have been regular for a second\n",
                topic, verdict == STAMPS_BACK ? "back" : "ahead", s(by_ns));
        break;
    case STAMPS_RESET:
        fprintf(stderr, "warning: the clock of the messages on %s was set; they count again\n",
                topic);
        memset(d->told, 0, sizeof d->told);
        break;
    case STAMPS_GOOD: break;
    }
}

static void take_odometry(struct ros_device *d, const struct ros_odometry *odometry)
{
    struct ros_motion motion;
    int64_t by_ns;
    const char *bad = ros_motion_of(odometry, &motion);
    enum stamps_verdict verdict;
    d->received_ns = frob_now_ns(&d->clock);
    d->told_silence = false;
    if (bad != NULL) {
        if (d->told_bad != bad)
            fprintf(stderr, "warning: a message on %s does not count: %s\n", d->started.odometry,
                    bad);
        d->told_bad = bad;
        return;
    }
    verdict = stamps_judge(&d->stamps, odometry->stamp_ns, odometry->arrived_ns,
                           (int64_t)(d->settings[ROS_LATE] * 1e9), &by_ns);
    tell_stamp(d, verdict, by_ns);
    if (verdict != STAMPS_GOOD && verdict != STAMPS_RESET)
        return;
    d->motion = motion;
    d->sensed_ns = odometry->arrived_ns - (verdict == STAMPS_GOOD ? by_ns : 0);
}

/* Reports that no more messages arrive, once until they do. */
static void tell_silence(struct ros_device *d)
{
    const int64_t now = frob_now_ns(&d->clock);
    if (d->received_ns == INT64_MIN || d->told_silence || now - d->received_ns < SILENCE_NS)
        return;
    d->told_silence = true;
    fprintf(stderr, "warning: no message on %s for %.0f s; the robot stands until one arrives\n",
            d->started.odometry, s(SILENCE_NS));
}

static void take(struct ros_device *d)
{
    switch (d->message.head.kind) {
    case ROS_STARTED: d->started = d->message.started; break;
    case ROS_ODOMETRY: take_odometry(d, &d->message.odometry); break;
    default: break;
    }
}

/* Handles the received messages, and keeps the beginning of the next one. Returns false if the bytes
 * are not messages. */
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

static enum frob_status poll_device(void *device)
{
    struct ros_device *d = (struct ros_device *)device;
    enum frob_status status = read_all(d);
    const bool due = frob_now_ns(&d->clock) >= d->sent_ns + REPEAT_NS;
    const bool connecting = d->sensed_ns == INT64_MIN;
    if (status == FROB_OK)
        tell_silence(d);
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
    return ((const struct ros_device *)device)->sensed_ns;
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
