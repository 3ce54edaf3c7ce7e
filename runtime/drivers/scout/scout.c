#include "drivers/scout/scout.h"

#include "drivers/pause.h"

#include <frob/scout.h>

#include <math.h>
#include <string.h>

#define SILENCE_NS INT64_C(1000000000)
#define UNHEARD_NS INT64_C(150000000)
#define LONGEST_PACKET 259 /* size in bytes of a packet whose length byte is 255, the maximum */
#define FORGOTTEN_NS INT64_C(500000000)
#define MOST_REFUSALS 3

static int64_t ns(double seconds)
{
    return (int64_t)(seconds * 1e9);
}

/* Sends a command and records that its answer is pending. If the line has no room, the command is
 * lost, and no answer arrives. */
static enum frob_status send(struct frob_scout *d, struct frob_scout_packet packet)
{
    uint8_t bytes[FROB_SCOUT_MAX_PACKET];
    size_t size = frob_scout_write_packet(&packet, bytes);
    enum frob_status status = d->serial.operations->write(d->serial.port, bytes, size);
    d->awaited = packet.type;
    d->sent_ns = frob_now_ns(&d->clock);
    return status == FROB_TIMEOUT ? FROB_OK : status;
}

static enum frob_status send_velocity(struct frob_scout *d)
{
    struct frob_wire wire = frob_scout_wire(d->settings[FROB_SCOUT_SEPARATION_M]);
    double now_s = (double)frob_now_ns(&d->clock) * 1e-9;
    bool left_first = d->settings[FROB_SCOUT_LEFT_FIRST] != 0.0;
    long left, right;
    d->speeds = frob_wire_next(&wire, &d->speeds, d->forward_m_s, d->turn_rad_s, now_s);
    left = (long)d->speeds.number[0].sent;
    right = (long)d->speeds.number[1].sent;
    d->velocity_waits = false;
    return send(d, left_first ? frob_scout_velocities(left, right)
                              : frob_scout_velocities(right, left));
}

/* Sends ST without waiting for a pending answer. ST makes the robot hold its position. */
static enum frob_status send_stop(struct frob_scout *d)
{
    static const uint8_t zeros[LONGEST_PACKET] = { 0 };
    enum frob_status status = send(d, frob_scout_plain(FROB_SCOUT_ST));
    if (status != FROB_OK || d->sent_ns - d->heard_ns < UNHEARD_NS)
        return status;
    status =
        d->serial.operations->write(d->serial.port, zeros, (size_t)d->settings[FROB_SCOUT_FLUSH]);
    return status == FROB_LOST ? status : send(d, frob_scout_plain(FROB_SCOUT_ST));
}

/* Returns the time at which to request the state if no velocity is sent. Returns INT64_MAX (never)
 * if the robot is moving and the host has stopped commanding it, so that the robot's watchdog stops
 * it. */
static int64_t ask_ns(const struct frob_scout *d)
{
    int64_t at_ns = d->sent_ns + ns(d->settings[FROB_SCOUT_POLL_S]);
    bool moves = d->forward_m_s != 0.0 || d->turn_rad_s != 0.0;
    return moves && at_ns - d->commanded_ns >= FORGOTTEN_NS ? INT64_MAX : at_ns;
}

/* Sends the next command, if no answer is pending. */
static enum frob_status send_next(struct frob_scout *d, int64_t now_ns)
{
    switch (d->step) {
    case FROB_SCOUT_STOPPING: return send_stop(d);
    case FROB_SCOUT_WATCHDOG:
        return send(d, frob_scout_watchdog((unsigned)d->settings[FROB_SCOUT_WATCHDOG_S]));
    case FROB_SCOUT_ACCELERATION:
        return send(d, frob_scout_acceleration((unsigned)lround(
                           d->settings[FROB_SCOUT_ACCELERATION_M_S2] / FROB_SCOUT_UNIT_M)));
    case FROB_SCOUT_SONARS_ON:
        return send(d, frob_scout_sonars_on((unsigned)d->settings[FROB_SCOUT_SONAR_MS] /
                                            FROB_SCOUT_SONAR_UNIT_MS));
    case FROB_SCOUT_CONNECTED: break;
    }
    if (d->velocity_waits)
        return send_velocity(d);
    if (now_ns >= ask_ns(d))
        return send(d, frob_scout_plain(FROB_SCOUT_GS));
    return FROB_OK;
}

/* Advances to the next connection step if this is the answer to the current step's command. The
 * answer to a stop that interrupted the step does not count. */
static void connect_further(struct frob_scout *d, uint8_t answered)
{
    static const uint8_t commands[] = { FROB_SCOUT_ST, FROB_SCOUT_CONF_TM, FROB_SCOUT_AC,
                                        FROB_SCOUT_CONF_SN };
    if (d->step == FROB_SCOUT_CONNECTED || answered != commands[d->step])
        return;
    d->step = (enum frob_scout_step)(d->step + 1);
    if (d->step == FROB_SCOUT_ACCELERATION && isnan(d->settings[FROB_SCOUT_ACCELERATION_M_S2]))
        d->step = FROB_SCOUT_SONARS_ON;
}

static void take_state(struct frob_scout *d, const struct frob_scout_packet *packet, int64_t now_ns)
{
    struct frob_scout_state state = frob_scout_read_state(packet);
    if (!frob_scout_odometry_add(&d->odometry, &state, now_ns))
        return;
    d->state = state;
    d->sensed_ns = now_ns;
    frob_scout_sonar_add(&d->sonar, &d->state, now_ns,
                         FROB_SCOUT_SONARS * ns(d->settings[FROB_SCOUT_SONAR_MS] * 1e-3));
}

/* Handles an answer. If the robot refuses a command while the driver is connecting, the connection
 * fails. A connected robot may occasionally refuse velocities because somebody is pressing the stop
 * button. */
static void take(struct frob_scout *d, const struct frob_scout_packet *packet, int64_t now_ns)
{
    bool refused = packet->type == FROB_SCOUT_NAK;
    bool answers = refused || packet->type == d->awaited;
    d->heard_ns = now_ns;
    if (frob_scout_is_state(packet))
        take_state(d, packet, now_ns);
    if (!answers || d->awaited == 0)
        return;
    if (d->awaited == FROB_SCOUT_VM)
        d->refusals = refused ? d->refusals + 1 : 0;
    if (refused && (d->step != FROB_SCOUT_CONNECTED || d->refusals >= MOST_REFUSALS))
        d->refused = true;
    d->awaited = 0;
    if (!refused)
        connect_further(d, packet->type);
}

static enum frob_status read_all(struct frob_scout *d)
{
    uint8_t bytes[64];
    size_t count;
    /* The limit exceeds what the line can deliver between two polls. It ends the loop even if bytes
       keep arriving. */
    for (int i = 0; i < 16; i++) {
        struct frob_scout_packet packet;
        enum frob_status status =
            d->serial.operations->read(d->serial.port, bytes, sizeof bytes, &count);
        if (status != FROB_OK)
            return status;
        if (count == 0)
            return FROB_OK;
        if (frob_after_pause(&d->clock, &d->byte_ns))
            memset(&d->receiver, 0, sizeof d->receiver);
        for (size_t k = 0; k < count; k++)
            if (frob_scout_receive(&d->receiver, bytes[k], &packet))
                take(d, &packet, frob_now_ns(&d->clock));
    }
    return FROB_OK;
}

static void start(void *device, const double *settings, const struct frob_serial *serial,
                  const struct frob_clock *clock)
{
    struct frob_scout *d = (struct frob_scout *)device;
    struct frob_scout_odometry odometry = d->odometry;
    memset(d, 0, sizeof *d);
    d->odometry = odometry;
    frob_scout_odometry_reconnect(&d->odometry);
    d->settings = settings;
    d->serial = *serial;
    d->clock = *clock;
    d->step = FROB_SCOUT_STOPPING;
    d->heard_ns = d->commanded_ns = frob_now_ns(clock);
    d->sensed_ns = INT64_MIN;
    /* Ignores a failure to set the rate: if the line has a fixed rate, either that rate is right,
     * or no answers will arrive. */
    serial->operations->set_rate(serial->port, (uint32_t)settings[FROB_SCOUT_BAUD]);
    serial->operations->discard(serial->port);
}

static enum frob_status poll(void *device)
{
    struct frob_scout *d = (struct frob_scout *)device;
    enum frob_status status = read_all(d);
    int64_t now_ns = frob_now_ns(&d->clock);
    if (status != FROB_OK)
        return status;
    if (d->refused)
        return FROB_REFUSED;
    if (now_ns - d->heard_ns >= SILENCE_NS)
        return FROB_TIMEOUT;
    if (d->awaited != 0 && now_ns - d->sent_ns >= ns(d->settings[FROB_SCOUT_PATIENCE_S]))
        d->awaited = 0;
    if (d->awaited == 0)
        status = send_next(d, now_ns);
    if (status != FROB_OK)
        return status;
    return d->step == FROB_SCOUT_CONNECTED ? FROB_OK : FROB_BUSY_CONNECTING;
}

static int64_t due_ns(const void *device)
{
    const struct frob_scout *d = (const struct frob_scout *)device;
    if (d->awaited != 0)
        return d->sent_ns + ns(d->settings[FROB_SCOUT_PATIENCE_S]);
    return d->velocity_waits || d->step != FROB_SCOUT_CONNECTED ? d->sent_ns : ask_ns(d);
}

static int64_t sensed_ns(const void *device)
{
    return ((const struct frob_scout *)device)->sensed_ns;
}

static void sense(void *device, void *into)
{
    struct frob_scout *d = (struct frob_scout *)device;
    struct frob_scout_input *input = (struct frob_scout_input *)into;
    const struct frob_scout_place *place = &d->odometry.place;
    double across = 0.5 * d->odometry.turn_rad_s * d->settings[FROB_SCOUT_SEPARATION_M];
    memset(input, 0, sizeof *input);
    input->odometry.position.x = place->x_m;
    input->odometry.position.y = place->y_m;
    input->odometry.heading = atan2(sin(place->heading_rad), cos(place->heading_rad));
    input->leftWheel = d->odometry.forward_m_s - across;
    input->rightWheel = d->odometry.forward_m_s + across;
    for (size_t i = 0; i < FROB_SCOUT_SONARS; i++) {
        double distance_m;
        if (frob_scout_sonar_take(&d->sonar, i, &distance_m)) {
            input->sonar[i].tag = FROB_EVENT_FLOAT_EVENT;
            input->sonar[i].f0 = distance_m;
        }
    }
    for (size_t i = 0; i < sizeof input->bumpers / sizeof input->bumpers[0]; i++)
        input->bumpers[i] = (d->state.bumpers >> i & 1) != 0;
    input->battery = d->state.motor_v;
    input->charging = (d->state.motor_status & FROB_SCOUT_CHARGING) != 0;
    input->emergencyStop = (d->state.motor_status & FROB_SCOUT_EMERGENCY_STOP) != 0;
}

static enum frob_status command(void *device, const void *from)
{
    struct frob_scout *d = (struct frob_scout *)device;
    const struct frob_scout_output *output = (const struct frob_scout_output *)from;
    if (d->step != FROB_SCOUT_CONNECTED)
        return FROB_BUSY_CONNECTING;
    d->forward_m_s = output->forward;
    d->turn_rad_s = output->turn;
    d->velocity_waits = true;
    d->commanded_ns = frob_now_ns(&d->clock);
    return d->awaited == 0 ? send_velocity(d) : FROB_OK;
}

static enum frob_status stop(void *device)
{
    struct frob_scout *d = (struct frob_scout *)device;
    d->velocity_waits = false;
    d->forward_m_s = d->turn_rad_s = 0.0;
    memset(&d->speeds, 0, sizeof d->speeds);
    d->commanded_ns = frob_now_ns(&d->clock);
    return send_stop(d);
}

static void close(void *device)
{
    struct frob_scout *d = (struct frob_scout *)device;
    stop(d);
    send(d, frob_scout_sonars_off());
}

static bool stands(const void *device)
{
    const struct frob_scout *d = (const struct frob_scout *)device;
    return d->odometry.forward_m_s == 0.0 && d->odometry.turn_rad_s == 0.0;
}

static const char *describe(const void *device)
{
    const struct frob_scout *d = (const struct frob_scout *)device;
    if (!d->refused)
        return "Nomadic Scout";
    return d->step == FROB_SCOUT_CONNECTED ? "Nomadic Scout, which rejects velocity commands"
                                           : "Nomadic Scout, which rejects its configuration";
}

static double most(const void *device, size_t i)
{
    const struct frob_scout *d = (const struct frob_scout *)device;
    return frob_wheels_most(i, d->settings[FROB_SCOUT_SEPARATION_M], FROB_SCOUT_MAX_M_S);
}

static const struct frob_setting settings_table[FROB_SCOUT_SETTING_COUNT] = {
    { "baud", 38400, 4800, 38400, "rate of the serial line, bits per second" },
    { "watchdog", 1, 1, 255, "seconds without a command after which the robot stops" },
    { "left-first", 0, 0, 1, "1 if the first axis of commands is the left wheel" },
    { "wheel-separation", 0.3452, 0.1, 1,
      "distance between the wheels, m (13.59 inches; others have measured 13.4)" },
    { "acceleration", NAN, 0.01, 10,
      "acceleration of the wheels, m/s^2 (default: the robot's own)" },
    { "sonar-period", 40, 4, 1020, "time between the pings of consecutive transducers, ms" },
    { "poll-period", 0.05, 0.01, 1, "time between two state requests, s" },
    { "patience", 0.1, 0.02, 1, "timeout for the answer to a command, s" },
    { "flush", LONGEST_PACKET, 0, LONGEST_PACKET,
      "number of zero bytes to send before repeating a stop command that the robot has not "
      "answered" },
};

static const size_t drives[] = { offsetof(struct frob_scout_output, forward),
                                 offsetof(struct frob_scout_output, turn) };

const struct frob_driver frob_scout_driver = {
    "scout",
    38400,
    sizeof(struct frob_scout),
    sizeof(struct frob_scout_input),
    sizeof(struct frob_scout_output),
    settings_table,
    FROB_SCOUT_SETTING_COUNT,
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
