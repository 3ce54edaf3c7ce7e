#include "drivers/create/create.h"

#include "drivers/create/command.h"
#include "drivers/create/lights.h"
#include "drivers/pause.h"

#include <frob/create.h>

#include <math.h>
#include <string.h>

#define MOST_PADDING 8
#define LONGEST_COMMAND 513 /* size in bytes of a song of 255 notes */

/* The sensor packets that the driver requests. */
static const uint8_t streamed[] = {
    FROB_CREATE_BUMPS_AND_DROPS,
    FROB_CREATE_CLIFF_LEFT,
    FROB_CREATE_CLIFF_FRONT_LEFT,
    FROB_CREATE_CLIFF_FRONT_RIGHT,
    FROB_CREATE_CLIFF_RIGHT,
    FROB_CREATE_VIRTUAL_WALL,
    FROB_CREATE_OVERCURRENT,
    FROB_CREATE_INFRARED,
    FROB_CREATE_BUTTONS,
    FROB_CREATE_CHARGING,
    FROB_CREATE_VOLTAGE,
    FROB_CREATE_CHARGE,
    FROB_CREATE_CAPACITY,
    FROB_CREATE_CLIFF_LEFT_SIGNAL,
    FROB_CREATE_CLIFF_FRONT_LEFT_SIGNAL,
    FROB_CREATE_CLIFF_FRONT_RIGHT_SIGNAL,
    FROB_CREATE_CLIFF_RIGHT_SIGNAL,
    FROB_CREATE_MODE,
    FROB_CREATE_LEFT_COUNTS,
    FROB_CREATE_RIGHT_COUNTS,
    FROB_CREATE_LIGHT_LEFT,
    FROB_CREATE_LIGHT_FRONT_LEFT,
    FROB_CREATE_LIGHT_CENTER_LEFT,
    FROB_CREATE_LIGHT_CENTER_RIGHT,
    FROB_CREATE_LIGHT_FRONT_RIGHT,
    FROB_CREATE_LIGHT_RIGHT,
};

/* A frame arrives every 15 ms. If the stream pauses, the driver requests it again. If the robot
 * stays silent for longer, the driver reports it as lost. */
#define ASK_AGAIN_NS INT64_C(150000000)
#define SILENCE_NS INT64_C(1000000000)
#define ANSWER_NS INT64_C(500000000)
#define MOST_ATTEMPTS 3
/* The number of consecutive frames that must report a different mode before the driver assumes
 * that the mode has changed. A single frame is not sufficient, because its checksum has only one
 * byte. */
#define OUT_OF_MODE_FRAMES 2
/* For this long after the driver has requested the stream, frames may be old: a radio link or a
 * busy adapter may have delayed frames from an earlier session, or from the time between START and
 * the change of mode. */
#define OLD_FRAMES_NS (ANSWER_NS / 2)

static int64_t ns(double seconds)
{
    return (int64_t)(seconds * 1e9);
}

static enum frob_status write(struct frob_create *d, const uint8_t *bytes, size_t size)
{
    enum frob_status status = d->serial.operations->write(d->serial.port, bytes, size);
    /* If the port has no space for the bytes, they are lost. If this truncates a command, the zeros
     * before the next one complete it. */
    return status == FROB_TIMEOUT ? FROB_OK : status;
}

static size_t pad(const struct frob_create *d, uint8_t *bytes)
{
    size_t padding = (size_t)d->settings[FROB_CREATE_PADDING];
    memset(bytes, 0, padding);
    return padding;
}

/* Sends zeros, which complete any command that the robot has only partly received. */
static enum frob_status flush(struct frob_create *d)
{
    static const uint8_t zeros[LONGEST_COMMAND] = { 0 };
    return d->settings[FROB_CREATE_PADDING] == 0.0 ? FROB_OK : write(d, zeros, sizeof zeros);
}

static enum frob_status drive(struct frob_create *d, int right_mm_s, int left_mm_s)
{
    uint8_t bytes[MOST_PADDING + FROB_CREATE_MAX_COMMAND];
    size_t size = pad(d, bytes);
    size += frob_create_drive_direct(right_mm_s, left_mm_s, bytes + size);
    return write(d, bytes, size);
}

static enum frob_status ask_for_stream(struct frob_create *d, int64_t now_ns)
{
    uint8_t bytes[MOST_PADDING + FROB_CREATE_MAX_COMMAND];
    size_t size = pad(d, bytes);
    size += frob_create_stream_request(streamed, sizeof streamed, bytes + size);
    d->asked_ns = now_ns;
    return write(d, bytes, size);
}

/* START also ends anything that another program has started, including motion. */
static enum frob_status send_start(struct frob_create *d)
{
    uint8_t bytes[1];
    enum frob_status status = flush(d);
    return status == FROB_OK ? write(d, bytes, frob_create_plain(FROB_CREATE_START, bytes))
                             : status;
}

static enum frob_status send_mode(struct frob_create *d)
{
    uint8_t bytes[1];
    bool full = d->settings[FROB_CREATE_IN_FULL] != 0.0;
    return write(d, bytes, frob_create_plain(full ? FROB_CREATE_FULL : FROB_CREATE_SAFE, bytes));
}

static enum frob_status begin_stream(struct frob_create *d, int64_t now_ns)
{
    enum frob_status status = flush(d);
    if (status == FROB_OK)
        status = drive(d, 0, 0);
    return status == FROB_OK ? ask_for_stream(d, now_ns) : status;
}

/* Performs the next connection step if it is due. The robot needs a pause after a change of
 * mode. */
static enum frob_status connect_further(struct frob_create *d, int64_t now_ns)
{
    int64_t since_ns = now_ns - d->step_ns;
    if (d->step == FROB_CREATE_RESTING) {
        d->step = FROB_CREATE_STARTED;
        d->step_ns = now_ns;
        return send_start(d);
    }
    if (d->step == FROB_CREATE_STARTED && since_ns >= ns(d->settings[FROB_CREATE_MODE_PAUSE_S])) {
        d->step = FROB_CREATE_IN_MODE;
        d->step_ns = now_ns;
        return send_mode(d);
    }
    if (d->step == FROB_CREATE_IN_MODE && since_ns >= ns(d->settings[FROB_CREATE_MODE_PAUSE_S])) {
        d->step = FROB_CREATE_STREAMING;
        d->step_ns = now_ns;
        return begin_stream(d, now_ns);
    }
    if (d->step == FROB_CREATE_STREAMING && since_ns >= ANSWER_NS) {
        if (++d->attempts >= MOST_ATTEMPTS)
            return FROB_TIMEOUT;
        d->step = FROB_CREATE_RESTING;
    }
    return FROB_OK;
}

static bool drives_in(const struct frob_create *d, unsigned mode)
{
    return mode == (d->settings[FROB_CREATE_IN_FULL] != 0.0 ? FROB_CREATE_MODE_FULL
                                                            : FROB_CREATE_MODE_SAFE);
}

/* Handles a frame. Ignores a frame with encoder counts that the robot cannot have reached, because
 * such a frame must be damaged. */
static void take(struct frob_create *d, const struct frob_create_sensors *sensors, int64_t now_ns)
{
    if (!frob_create_odometry_add(&d->odometry, sensors->left_counts, sensors->right_counts, now_ns,
                                  d->settings[FROB_CREATE_SEPARATION_M]))
        return;
    d->sensors = *sensors;
    d->heard_ns = now_ns;
    d->sensed_ns = now_ns;
    d->out_of_mode = drives_in(d, sensors->mode) ? 0 : d->out_of_mode + 1;
    if (d->step == FROB_CREATE_STREAMING && d->out_of_mode == 0)
        d->step = FROB_CREATE_CONNECTED;
    if (now_ns - d->step_ns < OLD_FRAMES_NS)
        return;
    if (d->step == FROB_CREATE_CONNECTED && d->out_of_mode >= OUT_OF_MODE_FRAMES)
        d->refused = true;
    if (d->step == FROB_CREATE_STREAMING)
        d->refused = true;
}

static enum frob_status read_all(struct frob_create *d)
{
    uint8_t bytes[256];
    size_t count;
    struct frob_create_sensors sensors = d->sensors;
    /* The limit exceeds what the line can deliver between two polls. It ends the loop even if bytes
       keep arriving. */
    for (int i = 0; i < 16; i++) {
        enum frob_status status =
            d->serial.operations->read(d->serial.port, bytes, sizeof bytes, &count);
        if (status != FROB_OK)
            return status;
        if (count == 0)
            return FROB_OK;
        if (frob_after_pause(&d->clock, &d->byte_ns))
            frob_create_stream_clear(&d->stream);
        for (size_t k = 0; k < count; k++)
            if (frob_create_stream_receive(&d->stream, bytes[k], &sensors))
                take(d, &sensors, frob_now_ns(&d->clock));
    }
    return FROB_OK;
}

static void start(void *device, const double *settings, const struct frob_serial *serial,
                  const struct frob_clock *clock)
{
    struct frob_create *d = (struct frob_create *)device;
    struct frob_create_odometry odometry = d->odometry;
    memset(d, 0, sizeof *d);
    d->odometry = odometry;
    frob_create_odometry_reconnect(&d->odometry);
    d->settings = settings;
    d->serial = *serial;
    d->clock = *clock;
    d->step = FROB_CREATE_RESTING;
    d->heard_ns = frob_now_ns(clock);
    d->sensed_ns = INT64_MIN;
    frob_create_stream_init(&d->stream, streamed, sizeof streamed,
                            settings[FROB_CREATE_HEADER_IN_SUM] != 0.0);
    /* Ignores a failure to set the rate: if the line has a fixed rate, either that rate is right,
     * or no frames will arrive. */
    serial->operations->set_rate(serial->port, (uint32_t)settings[FROB_CREATE_BAUD]);
    serial->operations->discard(serial->port);
}

static enum frob_status poll(void *device)
{
    struct frob_create *d = (struct frob_create *)device;
    enum frob_status status = read_all(d);
    int64_t now_ns = frob_now_ns(&d->clock);
    if (status != FROB_OK)
        return status;
    if (d->refused)
        return FROB_REFUSED;
    if (d->step != FROB_CREATE_CONNECTED) {
        status = connect_further(d, now_ns);
        return status == FROB_OK ? FROB_BUSY_CONNECTING : status;
    }
    if (now_ns - d->heard_ns >= SILENCE_NS)
        return FROB_TIMEOUT;
    if (now_ns - d->heard_ns >= ASK_AGAIN_NS && now_ns - d->asked_ns >= ASK_AGAIN_NS)
        return ask_for_stream(d, now_ns);
    return FROB_OK;
}

static int64_t due_ns(const void *device)
{
    const struct frob_create *d = (const struct frob_create *)device;
    int64_t asked_ns;
    switch (d->step) {
    case FROB_CREATE_RESTING: return d->heard_ns;
    case FROB_CREATE_STARTED:
    case FROB_CREATE_IN_MODE: return d->step_ns + ns(d->settings[FROB_CREATE_MODE_PAUSE_S]);
    case FROB_CREATE_STREAMING: return d->step_ns + ANSWER_NS;
    case FROB_CREATE_CONNECTED: break;
    }
    asked_ns = d->asked_ns > d->heard_ns ? d->asked_ns : d->heard_ns;
    return asked_ns + ASK_AGAIN_NS;
}

static int64_t sensed_ns(const void *device)
{
    return ((const struct frob_create *)device)->sensed_ns;
}

static bool bit(unsigned bits, double number)
{
    return (bits >> (unsigned)number & 1u) != 0;
}

static void sense(void *device, void *into)
{
    const struct frob_create *d = (const struct frob_create *)device;
    const struct frob_create_sensors *s = &d->sensors;
    struct frob_create_input *input = (struct frob_create_input *)into;
    memset(input, 0, sizeof *input);
    input->odometry.position.x = d->odometry.x_m;
    input->odometry.position.y = d->odometry.y_m;
    input->odometry.heading = atan2(sin(d->odometry.heading_rad), cos(d->odometry.heading_rad));
    input->leftWheel = d->odometry.left_m_s;
    input->rightWheel = d->odometry.right_m_s;
    input->bumpLeft = s->bump_left;
    input->bumpRight = s->bump_right;
    input->leftDrop = s->drop_left;
    input->rightDrop = s->drop_right;
    for (size_t i = 0; i < FROB_CREATE_CLIFFS; i++)
        input->cliffs[i] = s->cliff[i];
    for (size_t i = 0; i < FROB_CREATE_CLIFFS; i++)
        input->cliffSignals[i] = s->cliff_signal[i];
    for (size_t i = 0; i < FROB_CREATE_LIGHTS; i++)
        input->light[i] = s->light_signal[i];
    input->virtualWall = s->virtual_wall;
    input->beacon = s->infrared;
    input->leftOvercurrent = bit(s->overcurrent, d->settings[FROB_CREATE_LEFT_OVERCURRENT]);
    input->rightOvercurrent = bit(s->overcurrent, d->settings[FROB_CREATE_RIGHT_OVERCURRENT]);
    input->cleanButton = (s->buttons & 1u) != 0;
    input->battery = s->battery_mv * 1e-3;
    input->charge = s->capacity_mah == 0 ? 0.0 : fmin(1.0, (double)s->charge_mah / s->capacity_mah);
    input->charging = s->charging >= 1 && s->charging <= 3;
    input->obeying = drives_in(d, s->mode);
}

/* Also sends the state of the lights, whenever it changes and at least once per second. */
static enum frob_status command(void *device, const void *from)
{
    struct frob_create *d = (struct frob_create *)device;
    const struct frob_create_output *output = (const struct frob_create_output *)from;
    struct frob_wire wire = frob_create_wire(d->settings[FROB_CREATE_SEPARATION_M]);
    int64_t now_ns = frob_now_ns(&d->clock);
    uint8_t bytes[FROB_CREATE_MAX_COMMAND];
    size_t size;
    enum frob_status status;
    if (d->step != FROB_CREATE_CONNECTED)
        return FROB_BUSY_CONNECTING;
    d->speeds =
        frob_wire_next(&wire, &d->speeds, output->forward, output->turn, (double)now_ns * 1e-9);
    status = drive(d, (int)d->speeds.number[1].sent, (int)d->speeds.number[0].sent);
    size = frob_create_lights(output, bytes);
    if (status == FROB_OK &&
        (memcmp(bytes, d->lights, size) != 0 || now_ns - d->lights_ns >= SILENCE_NS)) {
        memcpy(d->lights, bytes, sizeof d->lights);
        d->lights_ns = now_ns;
        status = write(d, bytes, size);
    }
    if (status == FROB_OK && output->tone.tag == FROB_EVENT_TONE_EVENT)
        status = write(d, bytes, frob_create_tone(output, bytes));
    return status;
}

/* Stops the robot immediately. If the driver does not receive anything from the robot, it sends
 * zeros and the stop command again, because noise on the line may affect both directions. */
static enum frob_status stop(void *device)
{
    struct frob_create *d = (struct frob_create *)device;
    enum frob_status status = drive(d, 0, 0);
    memset(&d->speeds, 0, sizeof d->speeds);
    if (status != FROB_OK || frob_now_ns(&d->clock) - d->heard_ns < ASK_AGAIN_NS)
        return status;
    status = flush(d);
    return status == FROB_OK ? drive(d, 0, 0) : status;
}

/* START enters Passive mode, in which the robot does not drive. */
static void close(void *device)
{
    struct frob_create *d = (struct frob_create *)device;
    uint8_t bytes[FROB_CREATE_MAX_COMMAND];
    drive(d, 0, 0);
    write(d, bytes, frob_create_stream_pause(bytes));
    write(d, bytes, frob_create_plain(FROB_CREATE_START, bytes));
}

static bool stands(const void *device)
{
    const struct frob_create *d = (const struct frob_create *)device;
    return d->odometry.left_m_s == 0.0 && d->odometry.right_m_s == 0.0;
}

static const char *describe(const void *device)
{
    const struct frob_create *d = (const struct frob_create *)device;
    if (!d->refused)
        return "iRobot Create 2";
    return d->step == FROB_CREATE_CONNECTED ? "iRobot Create 2, which left driving mode because of "
                                              "a cliff, a wheel drop or a charger"
                                            : "iRobot Create 2, which does not enter driving mode";
}

static double most(const void *device, size_t i)
{
    const struct frob_create *d = (const struct frob_create *)device;
    struct frob_wire wire = frob_create_wire(d->settings[FROB_CREATE_SEPARATION_M]);
    return frob_wheels_most(i, wire.separation_m, wire.most[0]);
}

static const struct frob_setting settings_table[FROB_CREATE_SETTING_COUNT] = {
    { "baud", 115200, 300, 115200,
      "rate of the serial line, bits per second (57600 for a Create 1)" },
    { "full", 0, 0, 1,
      "1 for mode Full, in which the robot does not stop at cliffs or wheel drops" },
    { "header-in-sum", 1, 0, 1, "1 if the checksum includes the header (0 for a Create 1)" },
    { "wheel-separation", 0.235, 0.1, 1, "distance between the wheels, m (0.258 for a Create 1)" },
    { "mode-pause", 0.05, 0.02, 1, "pause after a change of mode, s" },
    { "padding", 4, 0, MOST_PADDING,
      "number of zero bytes sent before each drive command to complete a truncated command" },
    { "right-overcurrent", 3, 0, 7, "bit in packet 14 (pycreate2 uses 2)" },
    { "left-overcurrent", 4, 0, 7, "bit in packet 14 (pycreate2 uses 3)" },
};

static const size_t drives[] = { offsetof(struct frob_create_output, forward),
                                 offsetof(struct frob_create_output, turn) };

const struct frob_driver frob_create_driver = {
    "create",
    115200,
    sizeof(struct frob_create),
    sizeof(struct frob_create_input),
    sizeof(struct frob_create_output),
    settings_table,
    FROB_CREATE_SETTING_COUNT,
    drives,
    sizeof drives / sizeof drives[0],
    most,
    start,
    poll,
    due_ns,
    sensed_ns,
    sense,
    command,
    stop,
    close,
    describe,
    stands,
};
