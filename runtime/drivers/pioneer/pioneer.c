/* The functions of the driver's table: start, poll, command and stop. */
#include "drivers/pause.h"
#include "drivers/pioneer/device.h"
#include "drivers/pioneer/speeds.h"

#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846

enum {
    PAUSE_MS = 5,    /* interval between two commands; the AROS manual requires 3 to 5 ms */
    REFRESH_MS = 100 /* interval at which an unchanged command is repeated */
};

static const struct frob_setting settings[FROB_PIONEER_SETTING_COUNT] = {
    { "baud", 0, 0, 115200, "rate of the line, bits per second; 0: try the usual rates" },
    { "switch-baud", NAN, 0, 115200, "rate to switch to after connecting; 0: keep the rate" },
    { "angle", NAN, 1e-6, 1, "rad per unit of heading" },
    { "distance", NAN, 1e-6, 100, "mm per unit of position" },
    { "speed", NAN, 1e-6, 100, "mm/s per unit of wheel speed" },
    { "range", NAN, 1e-6, 100, "mm per unit of sonar range" },
    { "difference", NAN, 1e-6, 1,
      "twice the turn rate, rad/s, per mm/s of difference between the wheel speeds" },
    { "vel2-divisor", NAN, 1, 100, "mm/s per unit of the VEL2 command" },
    { "max-speed", FROB_PIONEER_MOST_M_S, 0.01, 2.2, "maximum commanded speed, m/s" },
    { "max-turn", FROB_PIONEER_MOST_RAD_S, 0.01, 9, "maximum commanded turn rate, rad/s" },
    { "wheels", 0, 0, 1, "1: command wheel speeds (VEL2) instead of forward speed and turn rate" },
    { "no-echo", 5.0, 0.1, 30, "minimum range that counts as no echo, m" },
    { "motors-flag", NAN, 0, 1, "1: the robot's flags report whether its motors are on" },
    { "hard-stop", 0, 0, 1, "1: stop without a ramp (E_STOP) in an emergency" },
    { "silence", 1.0, 0.1, 60, "time without a packet after which the driver reconnects, s" },
    { "interval", NAN, 0.01, 1,
      "minimum time between commands, s; default: 0.01, or 0.025 at up to 9600 baud or an unknown "
      "rate" },
    { "carry-on", 1, 0, 1, "1: between packets, extrapolate odometry from the wheel speeds" },
};

static struct frob_pioneer *pioneer(void *device)
{
    return (struct frob_pioneer *)device;
}

/* Clears the wanted speeds and the accumulated rounding error. */
static void forget_speeds(struct frob_pioneer *d)
{
    d->forward_m_s = d->turn_rad_s = 0.0;
    memset(&d->wanted, 0, sizeof d->wanted);
    memset(&d->sent, 0, sizeof d->sent);
    d->has_wanted = d->second_pending = false;
}

static void start(void *device, const double *values, const struct frob_serial *serial,
                  const struct frob_clock *clock)
{
    struct frob_pioneer *d = pioneer(device);
    d->settings = values;
    d->serial = *serial;
    d->clock = *clock;
    memset(&d->receiver, 0, sizeof d->receiver);
    memset(&d->sip, 0, sizeof d->sip);
    for (size_t i = 0; i < FROB_PIONEER_SONARS; i++) {
        d->sonar[i].heard_ns = INT64_MIN;
        d->sonar[i].fresh = false;
    }
    d->has_config = false;
    d->sensed_ns = INT64_MIN;
    d->sent_ns = INT64_MIN;
    d->heard_ns = frob_now_ns(clock);
    forget_speeds(d);
    d->description[0] = '\0';
    frob_pioneer_connect(d);
}

static bool by_wheels(const struct frob_pioneer *d)
{
    return d->settings[FROB_PIONEER_WHEELS] != 0.0;
}

static double most(const void *device, size_t i);

/* Converts the wanted speeds to the numbers to send now. */
static struct frob_wire_numbers numbers_now(const struct frob_pioneer *d)
{
    struct frob_wire wire =
        by_wheels(d) ? frob_pioneer_wheel_wire(d->model.vel2_divisor, d->model.difference)
                     : frob_pioneer_wire(most(d, 0), most(d, 1));
    return frob_wire_next(&wire, &d->sent, d->forward_m_s, d->turn_rad_s,
                          (double)frob_now_ns(&d->clock) * 1e-9);
}

static int32_t number(const struct frob_wire_numbers *numbers, int i)
{
    return (int32_t)numbers->number[i].sent;
}

static bool differ(const struct frob_wire_numbers *a, const struct frob_wire_numbers *b)
{
    return number(a, 0) != number(b, 0) || number(a, 1) != number(b, 1);
}

/* Sends the wanted speeds: VEL and, after a pause, RVEL; or VEL2. */
static enum frob_status send_first(struct frob_pioneer *d)
{
    uint8_t packet[FROB_P2OS_COMMAND_MOST];
    size_t length;
    d->sent = d->wanted = numbers_now(d);
    d->sent_ns = frob_now_ns(&d->clock);
    d->has_wanted = false;
    if (by_wheels(d)) {
        length =
            frob_p2os_command_bytes(packet, FROB_P2OS_VEL2, (uint8_t)(number(&d->sent, 1) & 0xFF),
                                    (uint8_t)(number(&d->sent, 0) & 0xFF));
    } else {
        d->second_pending = true;
        length = frob_p2os_command_int(packet, FROB_P2OS_VEL, number(&d->sent, 0));
    }
    return frob_pioneer_write(d, packet, length);
}

static enum frob_status send_second(struct frob_pioneer *d)
{
    d->second_pending = false;
    return frob_pioneer_send_int(d, FROB_P2OS_RVEL, number(&d->sent, 1));
}

/* Minimum interval between commands. VEL and RVEL together take up 18 bytes. If they were sent at
 * every step of a program, they would saturate a slow line and accumulate in a queue. A line of
 * unknown rate counts as slow. */
static double interval_s(const struct frob_pioneer *d)
{
    double set = d->settings[FROB_PIONEER_INTERVAL];
    return isnan(set) ? (d->rate <= 9600 ? 0.025 : 0.01) : set;
}

/* Returns the time at which VEL or VEL2 may be sent: immediately if the driver has not sent a
 * command yet, or if the pending command stops the robot. */
static int64_t first_due_ns(const struct frob_pioneer *d)
{
    bool changed = differ(&d->wanted, &d->sent);
    double pause_s = interval_s(d);
    if (!d->has_wanted)
        return INT64_MAX;
    if (d->sent_ns == INT64_MIN || (changed && d->forward_m_s == 0.0 && d->turn_rad_s == 0.0))
        return INT64_MIN;
    return d->sent_ns + (changed ? (int64_t)(pause_s * 1e9) : REFRESH_MS * frob_pioneer_ms);
}

static int64_t second_due_ns(const struct frob_pioneer *d)
{
    return d->second_pending ? d->sent_ns + PAUSE_MS * frob_pioneer_ms : INT64_MAX;
}

static enum frob_status send_due(struct frob_pioneer *d)
{
    int64_t now = frob_now_ns(&d->clock);
    enum frob_status status = FROB_OK;
    if (now >= second_due_ns(d))
        status = send_second(d);
    else if (!d->second_pending && now >= first_due_ns(d))
        status = send_first(d);
    return status;
}

static enum frob_status poll(void *device)
{
    struct frob_pioneer *d = pioneer(device);
    uint8_t bytes[256];
    size_t count, used;
    struct frob_p2os_packet packet;
    enum frob_status status;
    do {
        status = d->serial.operations->read(d->serial.port, bytes, sizeof bytes, &count);
        if (status == FROB_OK && count > 0 && frob_after_pause(&d->clock, &d->heard_ns))
            memset(&d->receiver, 0, sizeof d->receiver);
        for (used = 0; status == FROB_OK && used < count;) {
            used += frob_p2os_feed(&d->receiver, bytes + used, count - used);
            while (status == FROB_OK && frob_p2os_next(&d->receiver, &packet))
                status = frob_pioneer_connect_packet(d, &packet);
        }
    } while (status == FROB_OK && count == sizeof bytes);
    if (status == FROB_OK)
        status = frob_pioneer_connect_advance(d);
    if (status == FROB_OK)
        status = send_due(d);
    return status;
}

static int64_t due_ns(const void *device)
{
    const struct frob_pioneer *d = (const struct frob_pioneer *)device;
    int64_t due = second_due_ns(d), first = first_due_ns(d);
    if (d->phase != FROB_PIONEER_CONNECTED)
        return d->until_ns;
    if (!d->second_pending && first < due)
        due = first;
    return due;
}

static int64_t sensed_ns(const void *device)
{
    return ((const struct frob_pioneer *)device)->sensed_ns;
}

static double smaller(double a, double b)
{
    return a < b ? a : b;
}

/* Returns the minimum of the limits set by the user, the model and the robot, in m/s and rad/s. */
static double most(const void *device, size_t i)
{
    const struct frob_pioneer *d = (const struct frob_pioneer *)device;
    bool known = d->phase == FROB_PIONEER_CONNECTED;
    double model = i == 0 ? (known ? d->model.most_mm_s : 400.0) / 1000.0
                          : (known ? d->model.most_deg_s : 100.0) * PI / 180.0;
    double result =
        smaller(d->settings[i == 0 ? FROB_PIONEER_MAX_SPEED : FROB_PIONEER_MAX_TURN], model);
    if (known && d->has_config) {
        double top = i == 0 ? d->config.speed_top / 1000.0 : d->config.turn_top * PI / 180.0;
        if (top > 0.0)
            result = smaller(result, top);
    }
    return result;
}

static enum frob_status command(void *device, const void *output)
{
    struct frob_pioneer *d = pioneer(device);
    const struct frob_pioneer_output *out = (const struct frob_pioneer_output *)output;
    if (d->phase != FROB_PIONEER_CONNECTED)
        return FROB_BUSY_CONNECTING;
    d->forward_m_s = out->forward;
    d->turn_rad_s = out->turn;
    d->wanted = numbers_now(d);
    if (!differ(&d->wanted, &d->sent))
        d->sent = d->wanted; /* the robot already uses these numbers */
    d->has_wanted = true;
    return send_due(d);
}

/* Writes the stop commands. Both setpoints are set to zero first, because they persist after a
 * stop. */
static size_t stopping(const struct frob_pioneer *d, uint8_t *bytes)
{
    bool hard = d->settings[FROB_PIONEER_HARD_STOP] != 0.0;
    size_t length = frob_p2os_command_int(bytes, FROB_P2OS_VEL, 0);
    length += frob_p2os_command_int(bytes + length, FROB_P2OS_RVEL, 0);
    return length + frob_p2os_command(bytes + length, hard ? FROB_P2OS_E_STOP : FROB_P2OS_STOP);
}

static enum frob_status stop(void *device)
{
    struct frob_pioneer *d = pioneer(device);
    uint8_t bytes[3 * FROB_P2OS_COMMAND_MOST];
    forget_speeds(d);
    d->sent_ns = frob_now_ns(&d->clock);
    return frob_pioneer_write(d, bytes, stopping(d, bytes));
}

static void close(void *device)
{
    struct frob_pioneer *d = pioneer(device);
    stop(device);
    frob_pioneer_send(d, FROB_P2OS_CLOSE);
    d->phase = FROB_PIONEER_SILENT;
}

static bool stands(const void *device)
{
    const struct frob_pioneer *d = (const struct frob_pioneer *)device;
    return d->sip.left == 0 && d->sip.right == 0;
}

static const char *describe(const void *device)
{
    return ((const struct frob_pioneer *)device)->description;
}

static const size_t drives[] = { offsetof(struct frob_pioneer_output, forward),
                                 offsetof(struct frob_pioneer_output, turn) };

const struct frob_driver frob_pioneer_driver = {
    "pioneer",
    9600,
    sizeof(struct frob_pioneer),
    sizeof(struct frob_pioneer_input),
    sizeof(struct frob_pioneer_output),
    settings,
    FROB_PIONEER_SETTING_COUNT,
    drives,
    sizeof drives / sizeof drives[0],
    most,
    start,
    poll,
    due_ns,
    sensed_ns,
    frob_pioneer_sense,
    command,
    stop,
    close,
    describe,
    stands,
};
