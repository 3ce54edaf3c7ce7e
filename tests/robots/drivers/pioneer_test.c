/* Tests the Pioneer driver and the safety stop against a minimal robot that performs the
 * handshake, stores the commands it receives, and sends SIPs when told to. */
#include "check.h"

#include "core/robot.h"
#include "drivers/pioneer/pioneer.h"
#include "drivers/pioneer/protocol.h"
#include "hal/fake/fake.h"

#include <string.h>

#define MS INT64_C(1000000)

enum { LOG_ROOM = 4096 };

/* The robot at the other end of the line. */
static struct {
    struct frob_p2os_receiver receiver;
    const char *names; /* the names in the answer to SYNC2, after its type */
    size_t names_length;
    uint32_t rate; /* bit rate of the robot */
    bool in_session, open, heeds_hostbaud, keeps_rate, silent, motors;
    uint8_t expected_sync;
    int enables_lost; /* number of ENABLE commands to lose */
    bool strict;      /* echoes unknown packets, and disconnects at CLOSE */
    bool stands;      /* its wheels are at rest */
    bool deaf;        /* waits for the rest of a packet that noise began */
    uint8_t commands[LOG_ROOM];
    int32_t arguments[LOG_ROOM];
    int64_t times[LOG_ROOM];
    size_t count;
    int64_t sip_due;
    uint16_t x, y;
    int16_t heading;
} other;

static struct frob_fake_clock now;
static struct frob_fake_line line;
static struct frob_serial serial;
static struct frob_clock clock_;
static struct frob_pioneer device;
static struct frob_robot robot;
static double values[FROB_PIONEER_SETTING_COUNT];

static void send_body(const uint8_t *body, size_t length)
{
    uint8_t packet[FROB_P2OS_PACKET_MOST];
    uint16_t sum = frob_p2os_checksum(body, length);
    if (line.rate != other.rate || other.silent)
        return;
    packet[0] = 0xFA;
    packet[1] = 0xFB;
    packet[2] = (uint8_t)(length + 2);
    memcpy(packet + 3, body, length);
    packet[3 + length] = (uint8_t)(sum >> 8);
    packet[4 + length] = (uint8_t)(sum & 0xFF);
    frob_fake_send(&line, packet, length + 5, MS);
}

static void send_sip(uint8_t battery, const uint8_t *echoes, uint8_t echo_count)
{
    uint8_t b[128] = { 0x32 };
    size_t n = 20;
    b[1] = (uint8_t)(other.x & 0xFF);
    b[2] = (uint8_t)(other.x >> 8);
    b[3] = (uint8_t)(other.y & 0xFF);
    b[4] = (uint8_t)(other.y >> 8);
    b[5] = (uint8_t)((uint16_t)other.heading & 0xFF);
    b[6] = (uint8_t)((uint16_t)other.heading >> 8);
    b[7] = other.stands ? 0 : 100; /* left wheel, mm/s */
    b[9] = other.stands ? 0 : 200;
    b[11] = battery;
    b[12] = 0x02; /* a rear bumper */
    b[13] = 0x01; /* right stall */
    b[16] = other.motors;
    b[19] = echo_count;
    memcpy(b + n, echoes, 3u * echo_count);
    send_body(b, n + 3u * echo_count + 5u);
}

static void take(const struct frob_p2os_packet *packet)
{
    uint8_t number = packet->body[0];
    int32_t argument = 0;
    if (packet->length >= 4) {
        argument = packet->body[2] | packet->body[3] << 8;
        if (packet->body[1] == 0x1B)
            argument = -argument;
    }
    if (other.count < LOG_ROOM) {
        other.commands[other.count] = number;
        other.arguments[other.count] = argument;
        other.times[other.count++] = now.now_ns;
    }
    if (other.deaf)
        return;
    if (!other.in_session) {
        uint8_t body[64] = { number };
        if (number == 0)
            other.expected_sync = 0;
        if (other.strict && number > 2)
            send_body(packet->body, packet->length);
        if (other.strict && number == 2 && other.expected_sync != 2)
            line.lost = true;
        if (number > 2 || number != other.expected_sync++)
            return;
        if (number < 2)
            send_body(body, 1);
        if (number == 2) {
            memcpy(body + 1, other.names, other.names_length);
            send_body(body, 1 + other.names_length);
            other.in_session = true;
        }
    } else if (number == FROB_P2OS_CLOSE) {
        other.in_session = other.open = other.motors = false;
        line.lost = other.strict;
        if (!other.keeps_rate)
            other.rate = 9600;
    } else if (number == FROB_P2OS_OPEN) {
        other.open = true;
    } else if (number == FROB_P2OS_ENABLE) {
        other.motors = argument != 0 && other.enables_lost-- <= 0;
    } else if (number == FROB_P2OS_HOSTBAUD && other.heeds_hostbaud) {
        other.rate = argument == 2 ? 38400 : 9600;
    }
}

static void let_other_act(void)
{
    uint8_t bytes[64];
    size_t count, used;
    struct frob_p2os_packet packet;
    while ((count = frob_fake_receive(&line, bytes, sizeof bytes)) > 0) {
        if (line.rate != other.rate)
            continue;
        for (used = 0; used < count;) {
            used += frob_p2os_feed(&other.receiver, bytes + used, count - used);
            while (frob_p2os_next(&other.receiver, &packet))
                take(&packet);
        }
    }
    if (other.open && now.now_ns >= other.sip_due) {
        other.sip_due = now.now_ns + 100 * MS;
        send_sip(128, (const uint8_t *)"", 0);
    }
}

static void start(void)
{
    static const char names[] = "fake\0Pioneer\0P3DX-SH";
    memset(&other, 0, sizeof other);
    memset(&device, 0, sizeof device);
    memset(&robot, 0, sizeof robot);
    now.now_ns = 1000 * MS;
    frob_fake_line_open(&line, &now);
    serial = frob_fake_serial(&line);
    clock_ = frob_fake_time(&now);
    line.rate = 9600;
    other.rate = 9600;
    other.heeds_hostbaud = true;
    other.names = names;
    other.names_length = sizeof names;
    for (size_t i = 0; i < FROB_PIONEER_SETTING_COUNT; i++)
        values[i] = frob_pioneer_driver.settings[i].initial;
}

static void connect_again(void)
{
    frob_robot_start(&robot, &frob_pioneer_driver, &device, values, &serial, &clock_, 200 * MS);
}

/* Runs both ends for some time, in steps of a millisecond. */
static enum frob_robot_state run(int64_t ms)
{
    enum frob_robot_state state = robot.state;
    for (int64_t i = 0; i < ms; i++) {
        state = frob_robot_poll(&robot);
        let_other_act();
        now.now_ns += MS;
    }
    return state;
}

static enum frob_robot_state run_commanding(int64_t ms, double forward, double turn)
{
    struct frob_pioneer_output out;
    enum frob_robot_state state = robot.state;
    out.forward = forward;
    out.turn = turn;
    for (int64_t i = 0; i < ms; i++) {
        state = frob_robot_poll(&robot);
        if (i % 20 == 0)
            frob_robot_command(&robot, &out);
        let_other_act();
        now.now_ns += MS;
    }
    return state;
}

static size_t count_of(uint8_t number)
{
    size_t n = 0;
    for (size_t i = 0; i < other.count; i++)
        n += other.commands[i] == number;
    return n;
}

/* The index of the last command with this number; LOG_ROOM if there is none. */
static size_t last_of(uint8_t number)
{
    for (size_t i = other.count; i > 0; i--)
        if (other.commands[i - 1] == number)
            return i - 1;
    return LOG_ROOM;
}

static int32_t last_argument(uint8_t number)
{
    size_t i = last_of(number);
    return i == LOG_ROOM ? 99999 : other.arguments[i];
}

static void handshake(void)
{
    start();
    connect_again();
    check(run(1000) == FROB_ROBOT_READY, "connects within a second");
    check(strcmp(frob_pioneer_driver.describe(&device), "Pioneer P3DX-SH, fake") == 0,
          "says which robot it is");
    check(line.rate == 38400, "switches the rate as the model has it");
    check(other.commands[0] == FROB_P2OS_SYNC0 && other.commands[1] == 1 && other.commands[2] == 2,
          "nothing comes before SYNC0");
    check(other.commands[3] == FROB_P2OS_OPEN && other.commands[4] == FROB_P2OS_VEL &&
              other.commands[5] == FROB_P2OS_RVEL && other.arguments[4] == 0 &&
              other.arguments[5] == 0,
          "zeros are the first thing in the session");
    check(last_of(FROB_P2OS_ENABLE) != LOG_ROOM && last_of(FROB_P2OS_ENABLE) > 5 &&
              other.arguments[last_of(FROB_P2OS_ENABLE)] == 1,
          "turns the motors on");
    run(300);
    check(count_of(FROB_P2OS_CONFIG) == 3,
          "asks three times for a config packet, then goes without");
    start();
    other.enables_lost = 2;
    connect_again();
    check(run(1000) == FROB_ROBOT_READY && other.motors, "an ENABLE that is lost is sent again");
    start();
    other.enables_lost = 1000;
    connect_again();
    check(run(1500) == FROB_ROBOT_READY && !other.motors,
          "motors that stay off are the program's to see");
}

static void rates(void)
{
    size_t before;
    start();
    other.rate = 57600;
    connect_again();
    check(run(4000) == FROB_ROBOT_READY && line.rate == 38400, "finds the robot at the last rate");
    start();
    other.heeds_hostbaud = false;
    connect_again();
    check(run(4000) == FROB_ROBOT_READY && line.rate == 9600,
          "stays at the first rate when the robot does not switch");
    start();
    values[FROB_PIONEER_SWITCH_BAUD] = 0.0;
    connect_again();
    check(run(1000) == FROB_ROBOT_READY && line.rate == 9600, "a setting: no switching");
    start();
    line.refuses_rates = true; /* a bridge that keeps its rate */
    connect_again();
    check(run(1000) == FROB_ROBOT_READY && count_of(FROB_P2OS_HOSTBAUD) == 0,
          "a line that cannot change its rate: the robot is not told to");
    before = count_of(FROB_P2OS_VEL);
    for (int i = 0; i < 50; i++)
        run_commanding(20, 0.01 * i, 0.01 * i);
    check(count_of(FROB_P2OS_VEL) - before <= 42, "and its rate may be a slow one");
    line.refuses_rates = false;
    connect_again();
    check(run(2500) == FROB_ROBOT_READY && line.rate == 38400, "one that can: it is, later too");
    start();
    line.fastest = 9600;
    connect_again();
    check(run(1000) == FROB_ROBOT_READY && line.rate == 9600 && count_of(FROB_P2OS_HOSTBAUD) == 0,
          "a line that has the first rate but not the other: the robot is not told either");
    start();
    line.refuses_rates = true;
    values[FROB_PIONEER_BAUD] = 38400; /* the rate that the bridge was configured to */
    other.rate = 38400;
    line.rate = 38400;
    connect_again();
    check(run(1000) == FROB_ROBOT_READY, "a bridge whose rate is known");
    before = count_of(FROB_P2OS_VEL);
    for (int i = 0; i < 50; i++)
        run_commanding(20, 0.01 * i, 0.01 * i);
    check(count_of(FROB_P2OS_VEL) - before >= 48, "gets commands as often as that allows");
    start();
    other.silent = true;
    connect_again();
    check(run(12000) == FROB_ROBOT_FAILED && robot.status == FROB_TIMEOUT,
          "gives up when nobody answers");
}

static bool is_zero(size_t i, uint8_t number)
{
    return other.commands[i] == number && other.arguments[i] == 0;
}

/* A robot in an open session that starts to hear again: its watchdog has stopped it, and any
 * packet, even a pulse, would make it resume its old speed. */
static void hears_late(void)
{
    bool zeros_first = true;
    size_t ends = 0;
    start();
    other.in_session = other.open = other.deaf = true;
    connect_again();
    run(3000);
    for (size_t i = 0; i < other.count; i++) {
        if (other.commands[i] == FROB_P2OS_VEL || other.commands[i] == FROB_P2OS_RVEL)
            continue;
        ends++;
        zeros_first = zeros_first && other.commands[i] == FROB_P2OS_CLOSE && i >= 2 &&
                      is_zero(i - 2, FROB_P2OS_VEL) && is_zero(i - 1, FROB_P2OS_RVEL);
    }
    check(
        ends > 10 && zeros_first,
        "a session that is heard is ended, with zeros first, for they may be what is heard first");
    other.deaf = false;
    check(run(3000) == FROB_ROBOT_READY, "and when it hears again, another one is begun");
}

/* Noise instead of packets: there may be an open session behind it. */
static void noise(void)
{
    start();
    connect_again();
    run(20);
    frob_fake_send(&line, (const uint8_t *)"noise", 5, 0);
    run(400);
    check(is_zero(0, FROB_P2OS_VEL) && is_zero(1, FROB_P2OS_RVEL) &&
              other.commands[2] == FROB_P2OS_SYNC0,
          "after noise zeros come before SYNC0");
    run(600);
    check(robot.state == FROB_ROBOT_READY, "and it connects");
}

/* A simulator that echoes unknown packets and disconnects at CLOSE, as AMRISim does. */
static void strict_peer(void)
{
    start();
    other.strict = true;
    line.refuses_rates = true;
    connect_again();
    check(run(1000) == FROB_ROBOT_READY && !line.lost,
          "a peer that wants SYNC0 first is satisfied");
    run_commanding(300, 0.3, 0.0);
    check(last_argument(FROB_P2OS_VEL) == 300, "and drives");
    frob_robot_close(&robot);
    run(10);
    check(line.lost, "until CLOSE, when it hangs up");
}

/* Two halves of a packet with a pause between them are not a packet. */
static void torn(void)
{
    static const uint8_t sync0[] = { 0xFA, 0xFB, 3, 0, 0, 0 };
    start();
    other.silent = true;
    connect_again();
    run(160);
    frob_fake_send(&line, sync0, 3, 0);
    run(50);
    frob_fake_send(&line, sync0 + 3, 3, 0);
    run(10);
    check(last_of(1) != LOG_ROOM, "the halves of an echo 50 ms apart are one");
    start();
    other.silent = true;
    connect_again();
    run(160);
    frob_fake_send(&line, sync0, 3, 0);
    run(120);
    frob_fake_send(&line, sync0 + 3, 3, 0);
    run(10);
    check(last_of(1) == LOG_ROOM, "120 ms apart they are not");
}

static void stands(void)
{
    start();
    connect_again();
    run(1000);
    run_commanding(300, 0.3, 0.0);
    check(!frob_robot_stands(&robot), "a robot that is commanded does not stand");
    frob_robot_halt(&robot);
    run(300);
    check(!frob_robot_stands(&robot), "nor one that was told to stop, and rolls");
    other.stands = true;
    check(!frob_robot_stands(&robot), "which is known by a reading");
    run(300);
    check(frob_robot_stands(&robot), "that shows its wheels at rest");
}

static void sessions(void)
{
    size_t zero;
    start();
    /* a session that was never closed; the robot would resume its speed */
    other.in_session = other.open = true;
    connect_again();
    /* CLOSE and SYNC2 have the same number, so both are counted. */
    check(run(1500) == FROB_ROBOT_READY && count_of(FROB_P2OS_CLOSE) == 2,
          "ends a session that is still open, and begins its own");
    check(is_zero(0, FROB_P2OS_VEL) && is_zero(1, FROB_P2OS_RVEL),
          "zeros come before anything that a robot in a session takes for a pulse");
    start();
    other.in_session = true; /* its answer to SYNC2 was lost, and OPEN never arrived */
    values[FROB_PIONEER_BAUD] = 9600;
    connect_again();
    check(run(2500) == FROB_ROBOT_READY, "ends a session in which the robot says nothing");
    start();
    connect_again();
    run(1000);
    run_commanding(500, 0.3, 0.0);
    check(last_argument(FROB_P2OS_VEL) == 300, "drives");
    zero = other.count;
    connect_again();
    run(1500);
    check(run_commanding(1, 0.3, 0.0) == FROB_ROBOT_READY, "connects again");
    for (bool all = true; zero <= other.count; zero++) {
        if (zero == other.count)
            check(all, "after a new connection no speed is sent before zero was commanded");
        else if (other.commands[zero] == FROB_P2OS_VEL)
            all = all && other.arguments[zero] == 0;
    }
    start();
    connect_again();
    run(1000);
    run_commanding(500, 0.3, 0.0);
    connect_again();
    check(run(800) == FROB_ROBOT_READY, "a robot that is still in its session is back in 0.8 s");
    other.keeps_rate = true;
    connect_again();
    check(run(2500) == FROB_ROBOT_READY, "in 2.5 s if it keeps the session's rate");
    start();
    other.names = "x\0Pioneer\0p9zz";
    other.names_length = 15;
    connect_again();
    check(run(1000) == FROB_ROBOT_FAILED && robot.status == FROB_REFUSED,
          "refuses a model that it does not know");
}

static void driving(void)
{
    size_t before, first;
    bool apart = true;
    start();
    connect_again();
    run(1000);
    run_commanding(300, 0.25, 0.5);
    check(last_argument(FROB_P2OS_VEL) == 250 && last_argument(FROB_P2OS_RVEL) == 29,
          "speed in mm/s, turning in deg/s");
    run_commanding(300, -0.25, -0.5);
    check(last_argument(FROB_P2OS_VEL) == -250 && last_argument(FROB_P2OS_RVEL) == -29,
          "backwards and to the right");
    run_commanding(300, 50.0, -50.0);
    check(last_argument(FROB_P2OS_VEL) == 1200 && last_argument(FROB_P2OS_RVEL) == -300,
          "no more than the limits");
    run_commanding(300, 0.25, (double)NAN);
    check(last_argument(FROB_P2OS_VEL) == 0 && last_argument(FROB_P2OS_RVEL) == 0,
          "NaN stands still");
    run_commanding(300, 0.25, 0.0);
    run_commanding(300, (double)INFINITY, 0.5);
    check(last_argument(FROB_P2OS_VEL) == 0 && last_argument(FROB_P2OS_RVEL) == 0,
          "so does infinity");
    first = before = other.count;
    run_commanding(1000, 0.3, 0.0);
    for (size_t i = first + 1; i < other.count; i++)
        apart = apart && other.times[i] - other.times[i - 1] >= 4 * MS;
    check(apart, "commands are 5 ms apart");
    check(other.count - before >= 20 && other.count - before <= 24,
          "a speed that stays is sent ten times a second");
    values[FROB_PIONEER_WHEELS] = 1.0;
    run_commanding(300, 0.4, 0.56);
    /* left 400 - 100 mm/s is 15 units, right 400 + 100 is 25 */
    check(last_argument(FROB_P2OS_VEL2) == (15 << 8 | 25), "VEL2 commands the wheels");
}

/* The angle, in degrees, by which the RVEL commands from number `from` on have turned the robot. */
static double turned_by(size_t from)
{
    double way = 0.0;
    int32_t turn = 0;
    int64_t since = now.now_ns;
    for (size_t i = from; i < other.count; i++) {
        if (other.commands[i] != FROB_P2OS_RVEL)
            continue;
        way += turn * (double)(other.times[i] - since) / 1e9;
        turn = other.arguments[i];
        since = other.times[i];
    }
    return way + turn * (double)(now.now_ns - since) / 1e9;
}

/* 0.008 rad/s is 0.46 deg/s. At 9600 bits per second commands are 25 ms apart, and steps 20 ms. */
static void slow(void)
{
    size_t before;
    start();
    connect_again();
    run(1000);
    before = other.count;
    run_commanding(8000, 0.0, 0.008);
    check_near(turned_by(before), 0.064 * 180.0 / 3.14159265358979323846, 0.05,
               "a slow turn is as far as it should be");
    run_commanding(40, 0.0, 0.0);
    before = other.count;
    run_commanding(1000, 0.0, 0.0);
    check(turned_by(before) == 0.0, "what is owed does not move a robot that is told to stand");
    run_commanding(140, 0.0004, 0.008);
    frob_robot_halt(&robot);
    before = other.count;
    run(1000);
    check(turned_by(before) == 0.0 && last_argument(FROB_P2OS_VEL) == 0,
          "nor one that was stopped");
}

/* A Pioneer 1 reports wheel speeds in units of 2.5332 mm/s, according to the tables of ARIA and
 * Player. (AMRISim reports mm/s for it, so it cannot validate a Pioneer 1.) Its commands are in
 * mm/s. */
static void pioneer_1(void)
{
    static const char names[] = "old\0Pioneer\0PION1X";
    struct frob_pioneer_input in;
    start();
    other.names = names;
    other.names_length = sizeof names;
    connect_again();
    run(1000);
    frob_robot_sense(&robot, &in);
    check_near(in.leftWheel, 0.25332, 1e-12, "a Pioneer 1's wheels have a unit of their own");
    check_near(in.rightWheel, 0.50664, 1e-12, "both");
    run_commanding(300, 0.35, 0.0);
    check(last_argument(FROB_P2OS_VEL) == 350, "its commands are in mm/s");
}

static void stale(void)
{
    size_t stops;
    int64_t from;
    start();
    connect_again();
    run(1000);
    run_commanding(500, 0.3, 0.1);
    stops = count_of(FROB_P2OS_STOP);
    other.silent = true;
    from = now.now_ns;
    check(run_commanding(350, 0.3, 0.1) == FROB_ROBOT_STALE, "no reading for 200 ms is noticed");
    check(count_of(FROB_P2OS_STOP) > stops && last_argument(FROB_P2OS_VEL) == 0 &&
              last_argument(FROB_P2OS_RVEL) == 0,
          "the robot is stopped");
    for (size_t i = 0; i < other.count; i++) {
        if (other.commands[i] == FROB_P2OS_STOP && other.times[i] > from) {
            check(other.times[i] - from <= 202 * MS, "within 200 ms of the last reading");
            break;
        }
    }
    other.silent = false;
    check(run_commanding(300, 0.3, 0.1) == FROB_ROBOT_READY && last_argument(FROB_P2OS_VEL) == 300,
          "driving goes on when readings come again");
    other.silent = true;
    check(run_commanding(1500, 0.3, 0.1) == FROB_ROBOT_FAILED && robot.status == FROB_TIMEOUT,
          "a second of silence ends the connection");
}

static void halting(void)
{
    size_t stops;
    start();
    connect_again();
    run(1000);
    run_commanding(200, 0.3, 0.1);
    stops = count_of(FROB_P2OS_STOP);
    frob_robot_halt(&robot);
    let_other_act();
    check(count_of(FROB_P2OS_STOP) == stops + 1 && last_argument(FROB_P2OS_VEL) == 0,
          "halting stops at once");
    run(1000);
    check(count_of(FROB_P2OS_STOP) >= stops + 10 && last_argument(FROB_P2OS_VEL) == 0,
          "and goes on saying so");
    run_commanding(200, 0.2, 0.0);
    check(last_argument(FROB_P2OS_VEL) == 200, "until there is a command again");
    line.lost = true;
    check(run(1) == FROB_ROBOT_FAILED && robot.status == FROB_LOST, "a lost line is told");
}

static void sensing(void)
{
    struct frob_pioneer_input in;
    double range, age;
    start();
    values[FROB_PIONEER_CARRY_ON] = 0.0;
    other.x = 0x7FF0;
    other.y = 100;
    other.heading = 1024; /* a quarter turn: the axes of the robot's counters are rotated */
    connect_again();
    run(1000);
    frob_robot_sense(&robot, &in);
    check(in.odometry.position.x == 0.0 && in.odometry.position.y == 0.0 &&
              in.odometry.heading == 0.0,
          "odometry begins at zero, wherever the counters are");
    check_near(in.leftWheel, 0.1, 1e-12, "left wheel in m/s");
    check_near(in.rightWheel, 0.2, 1e-12, "right wheel in m/s");
    check_near(in.battery, 12.8, 1e-9, "battery in volts");
    check(in.rearBumper && !in.frontBumper && in.rightStall && !in.leftStall && in.motorsOn,
          "bumpers, stalls, motors");
    other.x = 0x0010; /* 32 mm further, past the counter's wraparound */
    other.y = 50;     /* 50 mm down */
    other.heading = 1024 + 512;
    run(200);
    frob_robot_sense(&robot, &in);
    check_near(in.odometry.position.x, -0.05, 1e-12, "counters turned into the robot's frame");
    check_near(in.odometry.position.y, -0.032, 1e-12, "and wrapping");
    check_near(in.odometry.heading, 0.785398163397448, 1e-12, "heading counts from the start");
    send_sip(128, (const uint8_t *)"\x02\xE8\x03\x05\x88\x13", 2);
    run(3);
    send_sip(128, (const uint8_t *)"\x07\xD0\x07", 1);
    run(3);
    frob_robot_sense(&robot, &in);
    check(in.sonar[2].tag == FROB_EVENT_FLOAT_EVENT && in.sonar[2].f0 == 1.0 &&
              in.sonar[7].tag == FROB_EVENT_FLOAT_EVENT && in.sonar[7].f0 == 2.0,
          "echoes of all packets since the last input");
    check(in.sonar[5].tag == FROB_EVENT_FLOAT_NO_EVENT, "5000 mm is no echo");
    frob_robot_sense(&robot, &in);
    check(in.sonar[2].tag == FROB_EVENT_FLOAT_NO_EVENT, "an echo is in one input only");
    run(100);
    check(frob_pioneer_echo(&device, 2, &range, &age) && range == 1.0 && age > 0.1 && age < 0.12,
          "an echo is remembered with its age");
    other.x = 0;
    connect_again();
    other.in_session = other.open = false;
    run(1500);
    frob_robot_sense(&robot, &in);
    check_near(in.odometry.position.y, -0.032, 1e-12, "odometry outlives a connection");
}

/* 100 and 200 mm/s, 0.28 rad/s: 50 ms after a packet. */
static void between_packets(void)
{
    struct frob_pioneer_input in;
    start();
    connect_again();
    run(1000);
    send_sip(128, (const uint8_t *)"", 0);
    other.sip_due = now.now_ns + 1000 * MS;
    run(2);
    now.now_ns = device.sensed_ns + 50 * MS;
    frob_robot_sense(&robot, &in);
    check_near(in.odometry.position.x, 0.0075, 1e-6, "between packets odometry goes on");
    check_near(in.odometry.heading, 0.014, 1e-9, "and turns");
    now.now_ns = device.sensed_ns + 900 * MS;
    frob_robot_sense(&robot, &in);
    check_near(in.odometry.position.x, 0.03, 1e-4, "but not for longer than 0.2 s");
}

int main(void)
{
    handshake();
    rates();
    sessions();
    hears_late();
    noise();
    strict_peer();
    torn();
    stands();
    driving();
    slow();
    pioneer_1();
    stale();
    halting();
    sensing();
    between_packets();
    return check_status();
}
