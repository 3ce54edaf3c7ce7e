/* Tests the guarantees of core/robot.h to drivers, with a minimal driver. */
#include "check.h"

#include "core/robot.h"
#include "hal/fake/fake.h"

#include <stddef.h>
#include <string.h>

/* A driver that keeps the pointers that it is given, which is allowed. */
struct keeper {
    const struct frob_serial *serial;
    const struct frob_clock *clock;
};

static void start(void *device, const double *settings, const struct frob_serial *serial,
                  const struct frob_clock *clock)
{
    struct keeper *k = (struct keeper *)device;
    (void)settings;
    k->serial = serial;
    k->clock = clock;
}

static enum frob_status poll(void *device)
{
    struct keeper *k = (struct keeper *)device;
    const uint8_t zero = 'z';
    (void)frob_now_ns(k->clock);
    return k->serial->operations->write(k->serial->port, &zero, 1);
}

static int64_t sensed_ns(const void *device)
{
    (void)device;
    return INT64_MIN;
}

static enum frob_status stop(void *device)
{
    (void)device;
    return FROB_OK;
}

static const struct frob_driver driver = { .robot = "keeper",
                                           .rate = 9600,
                                           .device_size = sizeof(struct keeper),
                                           .start = start,
                                           .poll = poll,
                                           .sensed_ns = sensed_ns,
                                           .stop = stop };

static void line_and_clock_stay(void)
{
    static struct frob_fake_clock now;
    static struct frob_fake_line line;
    static struct frob_robot robot;
    struct keeper device = { NULL, NULL };
    now.now_ns = 1000;
    frob_fake_line_open(&line, &now);
    {
        struct frob_serial serial = frob_fake_serial(&line);
        struct frob_clock clock = frob_fake_time(&now);
        frob_robot_start(&robot, &driver, &device, NULL, &serial, &clock, 100);
        memset(&serial, 0, sizeof serial);
        memset(&clock, 0, sizeof clock);
    }
    check(frob_robot_poll(&robot) != FROB_ROBOT_FAILED && device.serial->port != NULL &&
              device.clock->operations != NULL,
          "the line and the clock that a driver is given stay");
}

/* ---- Outages */

/* A driver for one drive; the test determines when readings arrive. */
struct rover {
    const struct frob_clock *clock;
    int64_t sensed_ns;
    double told;
    int commands, stops;
    int stops_at_poll; /* a real driver's poll sends a pending command */
};

struct rover_output {
    double speed;
};

static const size_t rover_drives[] = { offsetof(struct rover_output, speed) };

static void rover_start(void *device, const double *settings, const struct frob_serial *serial,
                        const struct frob_clock *clock)
{
    struct rover *r = (struct rover *)device;
    (void)settings;
    (void)serial;
    r->clock = clock;
}

static enum frob_status rover_poll(void *device)
{
    struct rover *r = (struct rover *)device;
    r->stops_at_poll = r->stops;
    return FROB_OK;
}

static int64_t rover_sensed_ns(const void *device)
{
    return ((const struct rover *)device)->sensed_ns;
}

static void rover_sense(void *device, void *input)
{
    (void)device;
    (void)input;
}

static double rover_most(const void *device, size_t drive)
{
    (void)device;
    (void)drive;
    return 1.0;
}

static enum frob_status rover_command(void *device, const void *output)
{
    struct rover *r = (struct rover *)device;
    r->told = ((const struct rover_output *)output)->speed;
    r->commands++;
    return FROB_OK;
}

static enum frob_status rover_stop(void *device)
{
    ((struct rover *)device)->stops++;
    return FROB_OK;
}

static int64_t rover_due_ns(const void *device)
{
    (void)device;
    return INT64_MAX;
}

static const struct frob_driver rover_driver = { .robot = "rover",
                                                 .rate = 9600,
                                                 .device_size = sizeof(struct rover),
                                                 .output_size = sizeof(struct rover_output),
                                                 .drives = rover_drives,
                                                 .drive_count = 1,
                                                 .most = rover_most,
                                                 .start = rover_start,
                                                 .poll = rover_poll,
                                                 .due_ns = rover_due_ns,
                                                 .sensed_ns = rover_sensed_ns,
                                                 .sense = rover_sense,
                                                 .command = rover_command,
                                                 .stop = rover_stop };

#define MS INT64_C(1000000)
#define PATIENCE_NS (200 * MS)

struct bench {
    struct frob_fake_clock now;
    struct frob_fake_line line;
    struct frob_robot robot;
    struct rover rover;
};

/* Runs an instant of a program that commands full speed, 20 ms after the previous instant, with a
 * reading that has just arrived. */
static void instant(struct bench *b)
{
    const struct rover_output full = { 1.0 };
    b->now.now_ns += 20 * MS;
    b->rover.sensed_ns = b->now.now_ns;
    if (frob_robot_poll(&b->robot) == FROB_ROBOT_READY) {
        frob_robot_sense(&b->robot, NULL);
        frob_robot_command(&b->robot, &full);
    }
}

/* Checks that the robot drives. */
static void begin(struct bench *b)
{
    struct frob_serial serial;
    struct frob_clock clock;
    memset(b, 0, sizeof *b);
    b->now.now_ns = 1000 * MS;
    frob_fake_line_open(&b->line, &b->now);
    serial = frob_fake_serial(&b->line);
    clock = frob_fake_time(&b->now);
    frob_robot_start(&b->robot, &rover_driver, &b->rover, NULL, &serial, &clock, PATIENCE_NS);
    instant(b);
    instant(b);
}

/* The speed of the first command within the next 50 instants; -1 if there is none. */
static double first_told(struct bench *b)
{
    const int before = b->rover.commands;
    for (int i = 0; i < 50; i++) {
        instant(b);
        if (b->rover.commands > before)
            return b->rover.told;
    }
    return -1.0;
}

static void first_command_is_zero(void)
{
    static struct bench b;
    begin(&b);
    check(b.rover.commands == 2 && b.rover.told == 1.0,
          "the second command of a connection is sent");
    b.now.now_ns += PATIENCE_NS - 30 * MS;
    frob_robot_poll(&b.robot);
    b.now.now_ns += 40 * MS;
    check(frob_robot_poll(&b.robot) == FROB_ROBOT_STALE && b.rover.stops > 0,
          "old readings stop the robot");
    check(first_told(&b) == 0.0, "after old readings the first command is zero");
    instant(&b);
    check(b.rover.told == 1.0, "the next one is the program's");
    frob_robot_halt(&b.robot);
    check(first_told(&b) == 0.0, "after a halt the first command is zero");
}

static void command_for_old_reading_is_dropped(void)
{
    static struct bench b;
    const struct rover_output full = { 1.0 };
    int commands;
    begin(&b);
    b.now.now_ns += 20 * MS;
    b.rover.sensed_ns = b.now.now_ns;
    frob_robot_poll(&b.robot);
    frob_robot_sense(&b.robot, NULL);
    commands = b.rover.commands;
    b.now.now_ns += PATIENCE_NS + MS;
    b.rover.sensed_ns = b.now.now_ns; /* a newer reading, which the program has not seen */
    frob_robot_command(&b.robot, &full);
    check(b.rover.commands == commands && b.rover.stops > 0 && b.robot.stale == 1,
          "a command for a reading that is too old is dropped, and the robot stopped");
    check(first_told(&b) == 0.0, "and the first command after that is zero");
}

static void old_readings_after_gap_do_not_count(void)
{
    static struct bench b;
    int64_t gone_ns;
    begin(&b);
    b.now.now_ns += 5000 * MS; /* as if the process had been stopped */
    gone_ns = b.now.now_ns;
    b.rover.stops = 0;
    frob_robot_poll(&b.robot);
    check(b.rover.stops_at_poll > 0, "after a gap in polling the robot is stopped before the poll");
    check(first_told(&b) == 0.0, "after a gap in polling the first command is zero");
    check(b.now.now_ns - gone_ns >= PATIENCE_NS, "and it comes when readings are new for certain");
}

int main(void)
{
    line_and_clock_stay();
    first_command_is_zero();
    command_for_old_reading_is_dropped();
    old_readings_after_gap_do_not_count();
    return check_status();
}
