/* Connects to a robot over an open line. A connected robot is at rest, with its motors on. */
#include "drivers/pioneer/device.h"

#include <math.h>
#include <string.h>

enum {
    OVERHEARING_MS = 150, /* longer than the time between two SIPs */
    SYNC_PATIENCE_MS = 250,
    SYNC_ATTEMPTS = 2,  /* number of attempts at each rate */
    ROUNDS = 3,         /* number of passes over all rates */
    CLOSING_MS = 200,   /* if a SIP arrives in the second half of this time, CLOSE was lost */
    STEP_MS = 20,       /* pause between the commands that open a session */
    SWITCHING_MS = 100, /* time that the robot needs to change its rate after HOSTBAUD */
    SIP_PATIENCE_MS = 1000,
    CONFIG_PATIENCE_MS = 300,
    CONFIG_ATTEMPTS = 3,
    AFTER_RATE = 6 /* the first opening step after the steps that switch the rate */
};

/* The usual bit rates, most likely first. */
static const uint32_t rates[] = { 9600, 38400, 19200, 115200, 57600 };
enum { RATE_COUNT = sizeof rates / sizeof rates[0] };

static int64_t after(const struct frob_pioneer *d, int64_t ms)
{
    return frob_now_ns(&d->clock) + ms * frob_pioneer_ms;
}

static enum frob_status set_rate(struct frob_pioneer *d, uint32_t rate)
{
    enum frob_status status = d->serial.operations->set_rate(d->serial.port, rate);
    if (status == FROB_OK)
        d->rate = rate;
    d->rate_fixed = status == FROB_UNSUPPORTED;
    /* A fixed rate is not an error: the driver then tries only that rate. */
    return status == FROB_UNSUPPORTED ? FROB_OK : status;
}

/* Checks whether the line can change to this rate, then restores the previous rate. */
static enum frob_status ask_rate(struct frob_pioneer *d, uint32_t rate, bool *can)
{
    const uint32_t before = d->rate;
    enum frob_status status = set_rate(d, rate);
    *can = !d->rate_fixed;
    return status == FROB_OK && *can ? set_rate(d, before) : status;
}

static enum frob_status send_zeros(struct frob_pioneer *d)
{
    enum frob_status status = frob_pioneer_send_int(d, FROB_P2OS_VEL, 0);
    return status == FROB_OK ? frob_pioneer_send_int(d, FROB_P2OS_RVEL, 0) : status;
}

/* Sends a SYNC and starts to wait for its echo. */
static enum frob_status send_sync(struct frob_pioneer *d, uint8_t sync)
{
    d->phase = FROB_PIONEER_SYNC;
    d->sync = sync;
    d->until_ns = after(d, SYNC_PATIENCE_MS);
    return frob_pioneer_send(d, sync);
}

/* Sends SYNC0 after listening to the line. A robot in a session reads SYNC0 as PULSE, and would
 * resume the speed that it had before its watchdog stopped it. A robot outside a session echoes
 * packets other than SYNC, or ends the connection. So if bytes have arrived, the driver sends zero
 * speeds first; if the line was silent, it sends only SYNC0. (SIPs prove that the robot is in a
 * session; bytes that are not packets prove nothing.) */
static enum frob_status overheard(struct frob_pioneer *d)
{
    bool silent = d->heard_ns <= d->until_ns - OVERHEARING_MS * frob_pioneer_ms;
    enum frob_status status = silent ? FROB_OK : send_zeros(d);
    return status == FROB_OK ? send_sync(d, 0) : status;
}

/* Stops the robot, and ends the session that the previous host left open. */
static enum frob_status end_session(struct frob_pioneer *d)
{
    enum frob_status status = send_zeros(d);
    d->good_rate = d->rate;
    d->phase = FROB_PIONEER_CLOSING;
    d->still_open = false;
    d->until_ns = after(d, CLOSING_MS);
    return status == FROB_OK ? frob_pioneer_send(d, FROB_P2OS_CLOSE) : status;
}

/* Returns the rate to try: first the rate at which a robot has answered before, then the usual
 * ones. */
static uint32_t rate_to_try(const struct frob_pioneer *d)
{
    if (d->settings[FROB_PIONEER_BAUD] > 0.0)
        return (uint32_t)d->settings[FROB_PIONEER_BAUD];
    if (d->good_rate != 0) {
        if (d->tried == 0)
            return d->good_rate;
        return rates[(d->tried - 1u) % RATE_COUNT];
    }
    return rates[d->tried % RATE_COUNT];
}

/* Starts to listen at the next rate. If earlier attempts got no answer, first sends CLOSE: a robot
 * whose answer to SYNC2 was lost is in a session, but sends nothing before OPEN. */
static enum frob_status try_rate(struct frob_pioneer *d)
{
    enum frob_status status = set_rate(d, rate_to_try(d));
    /* If the line cannot change its rate, assumes that it has the rate in the settings. */
    if (d->rate_fixed && d->settings[FROB_PIONEER_BAUD] > 0.0)
        d->rate = (uint32_t)d->settings[FROB_PIONEER_BAUD];
    d->attempt = 1;
    d->receiver.start = d->receiver.end = 0;
    if (status == FROB_OK)
        status = d->serial.operations->discard(d->serial.port);
    if (status == FROB_OK && d->tried > 0)
        status = frob_pioneer_send(d, FROB_P2OS_CLOSE);
    d->phase = FROB_PIONEER_OVERHEARING;
    d->until_ns = after(d, OVERHEARING_MS);
    return status;
}

void frob_pioneer_connect(struct frob_pioneer *d)
{
    d->tried = 0;
    d->switch_failed = false;
    d->phase = FROB_PIONEER_SYNC;
    d->sync = 0;
    d->attempt = SYNC_ATTEMPTS; /* set so that the first poll starts with the first rate */
    d->until_ns = frob_now_ns(&d->clock);
}

/* Returns the setting, or the model's value if the setting is NaN. */
static double chosen(const struct frob_pioneer *d, enum frob_pioneer_setting setting, double model)
{
    double value = d->settings[setting];
    return isnan(value) ? model : value;
}

static void add(char *text, size_t room, const char *part)
{
    size_t length = strlen(text);
    while (length + 1 < room && *part != '\0')
        text[length++] = *part++;
    text[length] = '\0';
}

static void describe(struct frob_pioneer *d)
{
    size_t room = sizeof d->description;
    d->description[0] = '\0';
    add(d->description, room, d->identity.robot_class);
    add(d->description, room, " ");
    add(d->description, room, d->identity.subclass);
    add(d->description, room, ", ");
    add(d->description, room, d->identity.name);
}

/* Handles the robot's identification. */
static enum frob_status identified(struct frob_pioneer *d)
{
    const struct frob_p2os_model *model = frob_p2os_find_model(d->identity.subclass);
    describe(d);
    if (model == NULL) {
        d->phase = FROB_PIONEER_UNKNOWN;
        frob_pioneer_send(d, FROB_P2OS_CLOSE);
        return FROB_REFUSED;
    }
    d->model = *model;
    d->model.angle = chosen(d, FROB_PIONEER_ANGLE, model->angle);
    d->model.distance = chosen(d, FROB_PIONEER_DISTANCE, model->distance);
    d->model.speed = chosen(d, FROB_PIONEER_SPEED, model->speed);
    d->model.range = chosen(d, FROB_PIONEER_RANGE, model->range);
    d->model.difference = chosen(d, FROB_PIONEER_DIFFERENCE, model->difference);
    d->model.vel2_divisor = chosen(d, FROB_PIONEER_VEL2_DIVISOR, model->vel2_divisor);
    d->model.switch_rate =
        (uint32_t)chosen(d, FROB_PIONEER_SWITCH_BAUD, (double)model->switch_rate);
    d->model.has_flags = chosen(d, FROB_PIONEER_MOTORS_FLAG, (double)model->has_flags) != 0.0;
    if (d->switch_failed)
        d->model.switch_rate = 0;
    d->good_rate = d->sync_rate = d->rate;
    d->phase = FROB_PIONEER_OPENING;
    d->step = 0;
    d->until_ns = frob_now_ns(&d->clock);
    return FROB_OK;
}

/* Returns the argument of HOSTBAUD for a rate, or -1 if there is none. */
static int32_t baud_number(uint32_t rate)
{
    switch (rate) {
    case 9600: return 0;
    case 19200: return 1;
    case 38400: return 2;
    case 57600: return 3;
    case 115200: return 4;
    default: return -1;
    }
}

static bool switches(const struct frob_pioneer *d)
{
    return !d->rate_fixed && d->model.switch_rate != d->rate &&
           baud_number(d->model.switch_rate) >= 0;
}

/* Asks the robot to switch its rate, but only if the line can switch too; otherwise the robot would
 * be unreachable, in this connection and in later ones. */
static enum frob_status send_hostbaud(struct frob_pioneer *d)
{
    bool can = false;
    enum frob_status status = switches(d) ? ask_rate(d, d->model.switch_rate, &can) : FROB_OK;
    if (!can)
        d->step = AFTER_RATE;
    else if (status == FROB_OK)
        status = frob_pioneer_send_int(d, FROB_P2OS_HOSTBAUD, baud_number(d->model.switch_rate));
    return status;
}

/* Sends the next of the commands that open the session. Both speeds are set to zero before
 * anything that could resume an old motion. */
static enum frob_status open_step(struct frob_pioneer *d)
{
    enum frob_status status = FROB_OK;
    int64_t pause_ms = STEP_MS;
    switch (d->step++) {
    case 0: status = frob_pioneer_send(d, FROB_P2OS_OPEN); break;
    case 1: status = frob_pioneer_send_int(d, FROB_P2OS_VEL, 0); break;
    case 2: status = frob_pioneer_send_int(d, FROB_P2OS_RVEL, 0); break;
    case 3: status = frob_pioneer_send(d, FROB_P2OS_PULSE); break;
    case 4:
        status = send_hostbaud(d);
        if (d->step == AFTER_RATE)
            return status;
        break;
    case 5:
        status = set_rate(d, d->model.switch_rate);
        pause_ms = SWITCHING_MS;
        break;
    case AFTER_RATE: status = frob_pioneer_send_int(d, FROB_P2OS_SONAR, 1); break;
    case 7:
        status = frob_pioneer_send_int(d, FROB_P2OS_ENABLE, 1);
        d->motors_seen = false;
        break;
    default:
        d->phase = FROB_PIONEER_LISTENING;
        d->config_asked = 0;
        d->config_due_ns = frob_now_ns(&d->clock);
        pause_ms = SIP_PATIENCE_MS;
        break;
    }
    d->until_ns = after(d, pause_ms);
    return status;
}

/* Handles a SYNC that was not echoed: tries again, tries another rate, or gives up. */
static enum frob_status sync_again(struct frob_pioneer *d)
{
    unsigned most = ROUNDS * RATE_COUNT;
    enum frob_status status;
    if (d->attempt < SYNC_ATTEMPTS) {
        d->attempt++;
        return send_sync(d, d->sync);
    }
    if (d->tried >= most) {
        d->phase = FROB_PIONEER_SILENT;
        return FROB_TIMEOUT;
    }
    status = try_rate(d);
    d->tried++;
    return status;
}

/* Handles missing SIPs: perhaps the robot did not switch to the new rate. */
static enum frob_status no_sip(struct frob_pioneer *d)
{
    if (d->rate == d->good_rate) {
        d->phase = FROB_PIONEER_SILENT;
        return FROB_TIMEOUT;
    }
    d->switch_failed = true;
    d->tried = 0;
    d->attempt = SYNC_ATTEMPTS;
    d->phase = FROB_PIONEER_SYNC;
    return sync_again(d);
}

static enum frob_status sync_packet(struct frob_pioneer *d, const struct frob_p2os_packet *packet)
{
    uint8_t type = packet->body[0];
    if (type == d->sync &&
        (type < 2 ? packet->length == 1 : frob_p2os_read_identity(packet, &d->identity))) {
        d->attempt = 1;
        return type < 2 ? send_sync(d, (uint8_t)(type + 1)) : identified(d);
    }
    if (type <= 2)
        return FROB_OK; /* this is the echo of a SYNC that was sent twice */
    return end_session(d);
}

/* Repeats ENABLE until the motors are on. Commands are not acknowledged, but SIPs report whether
 * the motors are on. Once they have been on, the driver leaves them alone: if they are off later,
 * somebody has turned them off. */
static enum frob_status ask_for_motors(struct frob_pioneer *d, const struct frob_p2os_sip *sip)
{
    if (!d->model.has_flags || d->motors_seen)
        return FROB_OK;
    d->motors_seen = (sip->flags & FROB_P2OS_FLAG_MOTORS) != 0;
    return d->motors_seen ? FROB_OK : frob_pioneer_send_int(d, FROB_P2OS_ENABLE, 1);
}

enum frob_status frob_pioneer_connect_packet(struct frob_pioneer *d,
                                             const struct frob_p2os_packet *packet)
{
    struct frob_p2os_sip sip;
    struct frob_p2os_robot_config config;
    switch (d->phase) {
    case FROB_PIONEER_OVERHEARING: return packet->body[0] > 2 ? end_session(d) : FROB_OK;
    case FROB_PIONEER_SYNC: return sync_packet(d, packet);
    case FROB_PIONEER_LISTENING:
        if (frob_p2os_read_sip(packet, &sip)) {
            d->has_counters = false;
            frob_pioneer_take_sip(d, &sip);
            d->good_rate = d->rate;
            d->phase = FROB_PIONEER_CONNECTED;
            return ask_for_motors(d, &sip);
        }
        break;
    case FROB_PIONEER_CONNECTED:
        if (frob_p2os_read_sip(packet, &sip)) {
            frob_pioneer_take_sip(d, &sip);
            return ask_for_motors(d, &sip);
        }
        if (frob_p2os_read_config(packet, &config)) {
            d->config = config;
            d->has_config = true;
        }
        break;
    case FROB_PIONEER_CLOSING:
        d->still_open = frob_now_ns(&d->clock) > d->until_ns - CLOSING_MS / 2 * frob_pioneer_ms;
        break;
    case FROB_PIONEER_OPENING:
    case FROB_PIONEER_SILENT:
    case FROB_PIONEER_UNKNOWN: break;
    }
    return FROB_OK;
}

/* Requests the config packet. If none arrives, the driver works without it. */
static enum frob_status ask_config(struct frob_pioneer *d)
{
    if (d->has_config || d->config_asked >= CONFIG_ATTEMPTS ||
        frob_now_ns(&d->clock) < d->config_due_ns)
        return FROB_OK;
    d->config_asked++;
    d->config_due_ns = after(d, CONFIG_PATIENCE_MS);
    return frob_pioneer_send(d, FROB_P2OS_CONFIG);
}

/* Sends SYNC0 after the end of a session. The robot has returned to the rate of its handshake, so
 * the driver tries that rate first, if it is known. Otherwise, the driver searches for the robot as
 * it does for the first connection. */
static enum frob_status sync_after_close(struct frob_pioneer *d)
{
    enum frob_status status = FROB_OK;
    if (d->sync_rate != 0 && d->sync_rate != d->rate)
        status = set_rate(d, d->sync_rate);
    if (status == FROB_OK)
        status = d->serial.operations->discard(d->serial.port);
    d->receiver.start = d->receiver.end = 0;
    d->attempt = 1;
    return status == FROB_OK ? send_sync(d, 0) : status;
}

enum frob_status frob_pioneer_connect_advance(struct frob_pioneer *d)
{
    int64_t now = frob_now_ns(&d->clock);
    bool due = now >= d->until_ns;
    enum frob_status status = FROB_OK;
    switch (d->phase) {
    case FROB_PIONEER_OVERHEARING: status = due ? overheard(d) : FROB_OK; break;
    case FROB_PIONEER_SYNC: status = due ? sync_again(d) : FROB_OK; break;
    case FROB_PIONEER_CLOSING:
        status = !due ? FROB_OK : d->still_open ? end_session(d) : sync_after_close(d);
        break;
    case FROB_PIONEER_OPENING: status = due ? open_step(d) : FROB_OK; break;
    case FROB_PIONEER_LISTENING: status = due ? no_sip(d) : FROB_OK; break;
    case FROB_PIONEER_CONNECTED:
        if ((double)(now - d->sensed_ns) > d->settings[FROB_PIONEER_SILENCE] * 1e9) {
            d->phase = FROB_PIONEER_SILENT;
            return FROB_TIMEOUT;
        }
        return ask_config(d);
    case FROB_PIONEER_SILENT: return FROB_TIMEOUT;
    case FROB_PIONEER_UNKNOWN: return FROB_REFUSED;
    }
    if (status != FROB_OK)
        return status;
    return d->phase == FROB_PIONEER_CONNECTED ? FROB_OK : FROB_BUSY_CONNECTING;
}
