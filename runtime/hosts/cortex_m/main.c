/* The main program on a microcontroller: the robot's line, the program's step
 * at a fixed rate with measured dt, and what stops the robot.
 *
 * There is no second process here. What stands for the supervisor is the
 * timer's interrupt: when a step has not ended within the patience, or the
 * loop does not come round, it tells the robot to stop, and again ten times a
 * second. A fault of the processor does the same. The controller gets no
 * further instant until it has come back. */
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include <frob/create.h>
#include <frob/pioneer.h>
#include <frob/program.h>
#include <frob/scout.h>

#include "core/robot.h"
#include "drivers/create/create.h"
#include "drivers/pioneer/pioneer.h"
#include "drivers/scout/scout.h"
#include "hal/cortex_m/board.h"

/* The compiled program, and the memory of its state, which `frobc build`
 * defines beside it. */
extern const struct frob_program frob_program;
extern void *const frob_program_state;

#ifndef FROB_RATE_HZ
#define FROB_RATE_HZ 50
#endif
#define MS INT64_C(1000000)
#define PERIOD_NS (1000 * MS / FROB_RATE_HZ)
#define PATIENCE_NS (200 * MS)
#define STOP_PERIOD_NS (100 * MS)
#define TOLD_PERIOD_NS (5000 * MS)

enum { SETTINGS_MOST = 32, RESULT_MOST = 256 };

static union {
    struct frob_pioneer pioneer;
    struct frob_scout scout;
    struct frob_create create;
} device;

static union {
    struct frob_pioneer_input pioneer;
    struct frob_scout_input scout;
    struct frob_create_input create;
} input;

/* The robot's struct, and behind it what a task has ended with. */
static union {
    double aligned;
    unsigned char bytes[FROB_OUTPUT_MOST + RESULT_MOST];
} output;

static const struct frob_driver *driver;
static double settings[SETTINGS_MOST];
static struct frob_robot robot;
static volatile int64_t alive_ns; /* when the loop last came round; 0: not running */
static int64_t stopped_ns;
static uint32_t steps, overruns, late;

/* From the timer's interrupt. The robot's stop needs nothing that the loop,
 * which is stuck, may be in the middle of, but the line: a packet that it
 * breaks off is one that the robot drops. */
static void watch(int64_t now_ns)
{
    if (alive_ns == 0 || now_ns - alive_ns <= PATIENCE_NS || now_ns - stopped_ns < STOP_PERIOD_NS)
        return;
    if (stopped_ns < alive_ns)
        late++;
    stopped_ns = now_ns;
    frob_robot_halt(&robot);
}

void board_on_fault(void)
{
    if (driver != NULL)
        frob_robot_halt(&robot);
    board_say("fault: the robot was told to stop\n");
    for (;;)
        __asm__ volatile("wfi");
}

static const struct frob_driver *find_driver(void)
{
    static const struct frob_driver *const drivers[] = { &frob_pioneer_driver, &frob_scout_driver,
                                                         &frob_create_driver };
    for (size_t i = 0; i < sizeof drivers / sizeof drivers[0]; i++)
        if (strcmp(drivers[i]->robot, frob_program.robot) == 0)
            return drivers[i];
    return NULL;
}

static void say_number(const char *name, uint32_t number)
{
    char digits[12];
    size_t at = sizeof digits - 1;
    digits[at] = '\0';
    do {
        digits[--at] = (char)('0' + number % 10u);
        number /= 10u;
    } while (number > 0);
    board_say(name);
    board_say(digits + at);
}

static void tell(int64_t now_ns)
{
    static int64_t told_ns;
    if (now_ns - told_ns < TOLD_PERIOD_NS)
        return;
    told_ns = now_ns;
    say_number("time ", (uint32_t)(now_ns / 1000000000));
    say_number(" s, steps ", steps);
    say_number(", overruns ", overruns);
    say_number(", late ", late);
    say_number(", stale ", robot.stale);
    say_number(", connections ", robot.connections);
    say_number(", stack ", (uint32_t)board_stack_used());
    board_say(" bytes\n");
}

static void start(void)
{
    frob_robot_start(&robot, driver, &device, settings, &board_serial, &board_clock, PATIENCE_NS);
}

/* One instant; `before_ns` is when the last one was, 0 if there was none. */
static int64_t instant(int64_t before_ns)
{
    int64_t now = frob_now_ns(&board_clock);
    frob_robot_sense(&robot, &input);
    memset(&output, 0, sizeof output);
    frob_program.step(frob_program_state, before_ns == 0 ? 0.0 : (double)(now - before_ns) / 1e9,
                      &input, &output);
    steps++;
    /* The command of a step that took too long is out of date. */
    if (frob_now_ns(&board_clock) - now <= PATIENCE_NS)
        frob_robot_command(&robot, &output);
    return now;
}

static void run(void)
{
    int64_t due = 0, before = 0;
    start();
    for (;;) {
        int64_t now = frob_now_ns(&board_clock), until = now + PERIOD_NS;
        enum frob_robot_state state;
        alive_ns = now;
        state = frob_robot_poll(&robot);
        if (state == FROB_ROBOT_FAILED) {
            start(); /* for as long as it takes */
            due = 0;
        } else if (state == FROB_ROBOT_READY && now >= due) {
            if (due != 0) {
                overruns += (uint32_t)((now - due) / PERIOD_NS);
                due += ((now - due) / PERIOD_NS + 1) * PERIOD_NS;
            } else {
                due = now + PERIOD_NS;
            }
            before = instant(before);
        } else if (state != FROB_ROBOT_READY) {
            due = 0;
        }
        tell(now);
        if (due != 0 && due < until)
            until = due;
        if (frob_robot_due_ns(&robot) < until)
            until = frob_robot_due_ns(&robot);
        board_serial.operations->wait(board_serial.port, until);
    }
}

int main(void)
{
    board_clock_start(watch);
    driver = find_driver();
    if (driver == NULL || frob_program.input_size != driver->input_size ||
        driver->input_size > sizeof input || driver->device_size > sizeof device ||
        frob_program.output_size < driver->output_size ||
        frob_program.output_size > sizeof output || driver->setting_count > SETTINGS_MOST) {
        board_serial_open(9600);
        board_say("this program is not for a robot with a driver here\n");
        return 1;
    }
    for (size_t i = 0; i < driver->setting_count; i++)
        settings[i] = driver->settings[i].initial;
    board_serial_open(driver->rate);
    frob_program.reset(frob_program_state);
    run();
    return 0;
}
