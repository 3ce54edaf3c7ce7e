#include "rover_driver.h"

#include "rover.h"

#include <math.h>
#include <string.h>

#define MOST_M_S 0.5 /* maximum speed of each wheel */
#define SILENCE_NS INT64_C(1000000000)
#define BATTERY_V (15.0 / 1023.0) /* volts per step of the A/D converter */
#define FARTHEST_CM 300
#define BATTERY_TURNS 40 /* one in this many range queries is replaced by a battery query */

static int64_t ns(double seconds)
{
    return (int64_t)(seconds * 1e9);
}

static enum frob_status send_bytes(struct rover *d, const uint8_t *bytes, size_t count)
{
    enum frob_status status = d->serial.operations->write(d->serial.port, bytes, count);
    /* If the line's buffer is full, the command is lost, and the wait for its answer times out. */
    return status == FROB_TIMEOUT ? FROB_OK : status;
}

static enum frob_status ask(struct rover *d, enum rover_awaited awaited, char letter, size_t count,
                            const int32_t *numbers)
{
    struct rover_command command = rover_write(letter, count, numbers);
    d->awaited = awaited;
    d->sent_ns = frob_now_ns(&d->clock);
    return send_bytes(d, command.bytes, command.count);
}

/* The first carriage return ends any partial line left by noise or by another program. */
static enum frob_status synchronize(struct rover *d)
{
    static const uint8_t bytes[] = { '\r', 'b', '\r' };
    if (d->awaited == ROVER_BATTERY)
        d->turn = 0; /* query the battery again immediately, not a second later */
    d->awaited = ROVER_SYNC;
    d->sent_ns = frob_now_ns(&d->clock);
    return send_bytes(d, bytes, sizeof bytes);
}

static enum frob_status send_stop(struct rover *d)
{
    static const uint8_t bytes[] = { '\r', 'm', ' ', '0', ' ', '0', '\r' };
    enum frob_status status = send_bytes(d, bytes, sizeof bytes);
    return status == FROB_OK ? synchronize(d) : status;
}

/* The range and resolution of speed commands, which are in counts per 1/30 s for each wheel. */
static struct frob_wire speeds_on_the_wire(const struct rover *d)
{
    double step_m_s = (double)ROVER_LOOPS / d->settings[ROVER_COUNTS_PER_M];
    struct frob_wire wire = {
        true, { step_m_s, step_m_s }, { MOST_M_S, MOST_M_S }, d->settings[ROVER_SEPARATION_M]
    };
    return wire;
}

static enum frob_status send_next(struct rover *d)
{
    if (!d->guarded) {
        int32_t watchdog_ms = (int32_t)d->settings[ROVER_WATCHDOG_MS];
        return ask(d, ROVER_WATCHDOG, 'w', 1, &watchdog_ms);
    }
    if (d->speed_waits) {
        struct frob_wire wire = speeds_on_the_wire(d);
        int32_t speeds[2];
        d->speeds = frob_wire_next(&wire, &d->speeds, d->forward_m_s, d->turn_rad_s,
                                   (double)frob_now_ns(&d->clock) * 1e-9);
        speeds[0] = (int32_t)d->speeds.number[0].sent;
        speeds[1] = (int32_t)d->speeds.number[1].sent;
        d->speed_waits = false;
        return ask(d, ROVER_SPEED, 'm', 2, speeds);
    }
    d->turn = (d->turn + 1) % (2 * BATTERY_TURNS);
    if (d->turn == 1) {
        static const int32_t pin = 0;
        return ask(d, ROVER_BATTERY, 'a', 1, &pin);
    }
    if (d->turn % 2 == 0)
        return ask(d, ROVER_COUNTS, 'e', 0, NULL);
    d->asked = (d->asked + 1) % ROVER_SONARS;
    int32_t ranger = (int32_t)d->asked;
    return ask(d, ROVER_ECHO, 'p', 1, &ranger);
}

static void take_echo(struct rover *d, int32_t cm)
{
    if (cm > 0) {
        d->fresh[d->asked] = true;
        d->echo_m[d->asked] = cm * 0.01;
    }
}

/* Processes the answer to the pending command. Returns false if it is not a valid answer to that
 * command. */
static bool take(struct rover *d, const struct rover_answer *answer, int64_t now_ns)
{
    bool number = answer->kind == ROVER_NUMBER;
    switch (d->awaited) {
    case ROVER_NOTHING: return false;
    case ROVER_SYNC: return number && answer->first == ROVER_RATE;
    case ROVER_SPEED: return answer->kind == ROVER_OK;
    case ROVER_WATCHDOG: /* a board without this command has a fixed timeout */
        d->guarded = answer->kind == ROVER_OK || answer->kind == ROVER_INVALID;
        return d->guarded;
    case ROVER_COUNTS:
        if (answer->kind != ROVER_PAIR)
            return false;
        if (rover_odometry_add(&d->odometry, answer->first, answer->second,
                               d->settings[ROVER_COUNTS_PER_M], d->settings[ROVER_SEPARATION_M],
                               now_ns))
            d->sensed_ns = now_ns;
        return true;
    case ROVER_ECHO:
        if (!number || answer->first < 0 || answer->first > FARTHEST_CM)
            return false;
        take_echo(d, answer->first);
        return true;
    case ROVER_BATTERY:
        if (!number || answer->first < 0 || answer->first > 1023)
            return false;
        d->battery_v = answer->first * BATTERY_V;
        return true;
    }
    return false;
}

static enum frob_status receive(struct rover *d, uint8_t byte, int64_t now_ns)
{
    struct rover_answer answer;
    if (!rover_receive(&d->receiver, byte, &answer))
        return FROB_OK;
    if (take(d, &answer, now_ns)) {
        d->awaited = ROVER_NOTHING;
        d->heard_ns = now_ns;
    } else if (d->awaited != ROVER_NOTHING && d->awaited != ROVER_SYNC) {
        return synchronize(d);
    }
    return FROB_OK;
}

static enum frob_status read_all(struct rover *d)
{
    uint8_t bytes[64];
    size_t count;
    /* The limit ends the loop even if bytes keep arriving. */
    for (int i = 0; i < 16; i++) {
        enum frob_status status =
            d->serial.operations->read(d->serial.port, bytes, sizeof bytes, &count);
        for (size_t k = 0; status == FROB_OK && k < count; k++)
            status = receive(d, bytes[k], frob_now_ns(&d->clock));
        if (status != FROB_OK || count == 0)
            return status;
    }
    return FROB_OK;
}

/* Connects; the first command that the robot receives is a speed of zero. */
static void start(void *device, const double *settings, const struct frob_serial *serial,
                  const struct frob_clock *clock)
{
    struct rover *d = (struct rover *)device;
    struct rover_odometry odometry = d->odometry;
    memset(d, 0, sizeof *d);
    d->odometry = odometry;
    rover_odometry_reconnect(&d->odometry);
    d->settings = settings;
    d->serial = *serial;
    d->clock = *clock;
    d->heard_ns = frob_now_ns(clock);
    d->sensed_ns = INT64_MIN;
    /* A failure to change the rate is ignored: either the line already has the right rate, or no
     * answer will come. */
    serial->operations->set_rate(serial->port, (uint32_t)settings[ROVER_BAUD]);
    serial->operations->discard(serial->port);
    send_stop(d);
}

static enum frob_status poll(void *device)
{
    struct rover *d = (struct rover *)device;
    enum frob_status status = read_all(d);
    int64_t now_ns = frob_now_ns(&d->clock);
    if (status != FROB_OK)
        return status;
    if (now_ns - d->heard_ns >= SILENCE_NS)
        return FROB_TIMEOUT;
    if (d->awaited == ROVER_NOTHING)
        status = send_next(d);
    else if (now_ns - d->sent_ns >= ns(d->settings[ROVER_PATIENCE_S]))
        status = synchronize(d);
    if (status != FROB_OK)
        return status;
    return d->guarded ? FROB_OK : FROB_BUSY_CONNECTING;
}

static int64_t due_ns(const void *device)
{
    const struct rover *d = (const struct rover *)device;
    return d->awaited == ROVER_NOTHING ? d->sent_ns
                                       : d->sent_ns + ns(d->settings[ROVER_PATIENCE_S]);
}

static int64_t sensed_ns(const void *device)
{
    return ((const struct rover *)device)->sensed_ns;
}

static void sense(void *device, void *into)
{
    struct rover *d = (struct rover *)device;
    struct frob_rover_input *input = (struct frob_rover_input *)into;
    const struct rover_odometry *o = &d->odometry;
    memset(input, 0, sizeof *input);
    input->odometry.position.x = o->x_m;
    input->odometry.position.y = o->y_m;
    input->odometry.heading = atan2(sin(o->heading_rad), cos(o->heading_rad));
    input->leftWheel = o->left_m_s;
    input->rightWheel = o->right_m_s;
    for (size_t i = 0; i < ROVER_SONARS; i++) {
        if (d->fresh[i]) {
            input->sonar[i].tag = FROB_EVENT_FLOAT_EVENT;
            input->sonar[i].f0 = d->echo_m[i];
            d->fresh[i] = false;
        }
    }
    input->battery = d->battery_v;
}

static enum frob_status command(void *device, const void *from)
{
    struct rover *d = (struct rover *)device;
    const struct frob_rover_output *output = (const struct frob_rover_output *)from;
    if (!d->guarded)
        return FROB_BUSY_CONNECTING;
    d->forward_m_s = output->forward;
    d->turn_rad_s = output->turn;
    d->speed_waits = true;
    return d->awaited == ROVER_NOTHING ? send_next(d) : FROB_OK;
}

static enum frob_status stop(void *device)
{
    struct rover *d = (struct rover *)device;
    d->speed_waits = false;
    memset(&d->speeds, 0, sizeof d->speeds);
    return send_stop(d);
}

static void close(void *device)
{
    stop(device);
}

static bool stands(const void *device)
{
    const struct rover *d = (const struct rover *)device;
    return d->odometry.left_m_s == 0.0 && d->odometry.right_m_s == 0.0;
}

static const char *describe(const void *device)
{
    (void)device;
    return "Rover";
}

static double most(const void *device, size_t i)
{
    const struct rover *d = (const struct rover *)device;
    return frob_wheels_most(i, d->settings[ROVER_SEPARATION_M], MOST_M_S);
}

static const struct frob_setting settings_table[ROVER_SETTING_COUNT] = {
    { "baud", ROVER_RATE, 9600, 115200, "rate of the serial line, bits per second" },
    { "watchdog", 500, 100, 2000,
      "milliseconds without a speed command after which the robot stops" },
    { "counts", ROVER_COUNTS_A_METRE, 100, 1000000, "encoder counts per metre of travel" },
    { "wheel-separation", 0.19, 0.05, 1, "distance between the wheels, m" },
    { "patience", 0.06, 0.01, 1, "timeout for the answer to a command, s" },
};

static const size_t drives[] = { offsetof(struct frob_rover_output, forward),
                                 offsetof(struct frob_rover_output, turn) };

const struct frob_driver frob_rover_driver = {
    "rover",
    ROVER_RATE,
    sizeof(struct rover),
    sizeof(struct frob_rover_input),
    sizeof(struct frob_rover_output),
    settings_table,
    ROVER_SETTING_COUNT,
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
