/* Tests the main loop of boards without an operating system, on a fake line in virtual time: its
 * behaviour when a step takes too long, with the step itself calling the timer's interrupt
 * handler. */
#include "check.h"

#include "drivers/driver.h"
#include "drivers/pioneer/packet.h"
#include "drivers/pioneer/pioneer.h"
#include "drivers/pioneer/protocol.h"
#include "hal/fake/fake.h"
#include "hosts/board/loop.h"
#include <frob/arithmetic.h>
#include <frob/pioneer.h>
#include <frob/program.h>

#include <string.h>

#define MS INT64_C(1000000)

static struct frob_fake_clock now;
static struct frob_fake_line line;
static struct frob_serial serial;
static struct frob_clock clock_;

/* ---- The program */

static int64_t step_takes_ns;
static double last_dt;
static double state;
void *const frob_program_state = &state;

/* The loop has its own driver, for a robot that the runtime does not know. */
static struct frob_driver own_driver = { .robot = "rover" };
extern const struct frob_driver *const frob_own_driver;
const struct frob_driver *const frob_own_driver = &own_driver;

static void reset(void *s, const void *params)
{
    (void)params;
    *(double *)s = 0.0;
}

/* Drives at 0.3 m/s; the timer interrupts it while it runs. */
static void step(void *s, const void *params, int64_t dt_ns, double dt, const void *in, void *out)
{
    struct frob_pioneer_output *o = (struct frob_pioneer_output *)out;
    (void)params;
    (void)dt_ns;
    (void)in;
    *(double *)s += dt;
    last_dt = dt;
    for (int64_t end = now.now_ns + step_takes_ns; now.now_ns < end; now.now_ns += MS)
        loop_watch(now.now_ns);
    o->forward = 0.3;
    o->turn = 0.0;
}

static bool is_damaged;

static bool is_valid(const void *s)
{
    (void)s;
    return !is_damaged;
}

static unsigned arithmetic_faults;

static unsigned arithmetic(void)
{
    return arithmetic_faults;
}

const struct frob_program frob_program = { .abi = FROB_PROGRAM_ABI,
                                           .name = "drive",
                                           .robot = "pioneer",
                                           .state_size = sizeof(double),
                                           .input_size = sizeof(struct frob_pioneer_input),
                                           .output_size = sizeof(struct frob_pioneer_output),
                                           .reset = reset,
                                           .step = step,
                                           .is_valid = is_valid,
                                           .arithmetic = arithmetic };

/* ---- The robot */

static struct {
    struct frob_p2os_receiver receiver;
    bool in_session, silent;
    int64_t sip_ns;
    int32_t speed;
    unsigned stops, zeros;
} robot;

static void send_body(const uint8_t *body, size_t length)
{
    uint8_t packet[64] = { 0xFA, 0xFB, (uint8_t)(length + 2) };
    uint16_t sum = frob_p2os_checksum(body, length);
    memcpy(packet + 3, body, length);
    packet[3 + length] = (uint8_t)(sum >> 8);
    packet[4 + length] = (uint8_t)(sum & 0xFF);
    frob_fake_send(&line, packet, length + 5, 0);
}

static void take(const struct frob_p2os_packet *p)
{
    static const uint8_t names[] = "\2x\0Pioneer\0p3dx";
    static const uint8_t first[] = { 0, 1 };
    if (!robot.in_session && p->body[0] < 2)
        send_body(&first[p->body[0]], 1);
    if (!robot.in_session && p->body[0] == FROB_P2OS_CLOSE) {
        send_body(names, sizeof names);
        robot.in_session = true;
    }
    if (p->body[0] == FROB_P2OS_VEL) {
        robot.speed = p->body[2] | p->body[3] << 8;
        robot.zeros += robot.speed == 0;
    }
    robot.stops += p->body[0] == FROB_P2OS_STOP;
}

static void let_robot_act(void)
{
    static const uint8_t sip[25] = { 0x32, [16] = 1 };
    uint8_t bytes[64];
    size_t count, used;
    struct frob_p2os_packet packet;
    while ((count = frob_fake_receive(&line, bytes, sizeof bytes)) > 0)
        for (used = 0; used < count;) {
            used += frob_p2os_feed(&robot.receiver, bytes + used, count - used);
            while (frob_p2os_next(&robot.receiver, &packet))
                take(&packet);
        }
    if (robot.in_session && !robot.silent && now.now_ns >= robot.sip_ns) {
        robot.sip_ns = now.now_ns + 50 * MS;
        send_body(sip, sizeof sip);
    }
}

static void run(int64_t ms)
{
    for (int64_t end = now.now_ns + ms * MS; now.now_ns < end;) {
        int64_t until = loop_round();
        let_robot_act();
        now.now_ns += MS;
        if (until > now.now_ns + MS)
            loop_watch(now.now_ns);
    }
}

/* Registers a user-defined driver that needs this many bytes; starts the loop. */
static const char *start_with(size_t device_size)
{
    own_driver = frob_pioneer_driver;
    own_driver.device_size = device_size;
    return loop_start(&serial, &clock_);
}

static void own_drivers(void)
{
    const char *said;
    check(start_with(9000) == NULL, "an own driver has the room that the loop was compiled with");
    said = start_with(9001);
    check(said != NULL && strstr(said, "FROB_DEVICE_MOST") != NULL,
          "one that needs more is told what to change");
    own_driver.robot = "rover";
}

int main(void)
{
    unsigned stops;
    struct loop_counts before;
    now.now_ns = 1000 * MS;
    frob_fake_line_open(&line, &now);
    serial = frob_fake_serial(&line);
    clock_ = frob_fake_time(&now);
    arithmetic_faults = FROB_ARITHMETIC_CONTRACTION;
    check(loop_start(&serial, &clock_) != NULL && loop_count().steps == 0,
          "a program with other arithmetic does not begin");
    arithmetic_faults = 0;
    own_drivers();
    check(loop_line_rate() == 9600 && loop_start(&serial, &clock_) == NULL,
          "a program for a robot");
    run(1500);
    check(loop_count().connections == 1 && robot.speed == 300, "connects and drives");
    before = loop_count();
    run(1000);
    check(loop_count().steps - before.steps >= 49 && loop_count().steps - before.steps <= 51,
          "fifty steps a second");
    check_near(last_dt, 0.02, 0.0011, "dt is measured");
    check(loop_count().overruns == 0 && loop_count().late == 0, "all in time");

    step_takes_ns = 50 * MS;
    run(1000);
    check(loop_count().overruns > 20 && loop_count().late == 0 && robot.speed == 300,
          "steps of 50 ms come too late, and are counted");

    stops = robot.stops;
    step_takes_ns = 1000 * MS;
    before = loop_count();
    while (loop_count().steps == before.steps)
        run(1);
    step_takes_ns = 0;
    check(loop_count().late == 1, "a step of a second is late");
    check(robot.stops >= stops + 7, "the robot is told to stop, and again, while it runs");
    check(robot.speed == 0, "its command is not sent");
    run(500);
    check(robot.speed == 300 && loop_count().late == 1, "that of the next one is");

    robot.silent = true;
    run(400);
    /* The readings were stale after the late step, too. */
    check(robot.speed == 0 && loop_count().stale == 2, "old readings stop the robot");
    robot.silent = false;
    robot.in_session = false;
    run(4000);
    check(loop_count().connections == 2 && robot.speed == 300, "it connects again");

    is_damaged = true;
    before = loop_count();
    run(500);
    check(robot.speed == 0 && loop_count().steps == before.steps && loop_count().damaged > 20,
          "no step runs on a damaged state, and the robot rests");
    is_damaged = false;
    run(500);
    check(robot.speed == 300, "it drives again");
    loop_stop();
    let_robot_act();
    check(robot.speed == 0, "a fault stops the robot");
    return check_status();
}
