#include "hosts/board/loop.h"

#include <stdbool.h>
#include <string.h>

#include <frob/arithmetic.h>
#include <frob/console.h>
#include <frob/create.h>
#include <frob/pioneer.h>
#include <frob/program.h>
#include <frob/scout.h>

#include "core/robot.h"
#include "drivers/create/create.h"
#include "drivers/pioneer/pioneer.h"
#include "drivers/scout/scout.h"

/* The compiled program, and the memory for its state, which `frobc` defines in the same file. */
extern const struct frob_program frob_program;
extern void *const frob_program_state;

#ifndef FROB_RATE_HZ
#define FROB_RATE_HZ 50
#endif
#define MS INT64_C(1000000)
#define PERIOD_NS (1000 * MS / FROB_RATE_HZ)
#define PATIENCE_NS (200 * MS)
#define STOP_PERIOD_NS (100 * MS)

enum { SETTINGS_MOST = 32, RESULT_MOST = 256, CONSOLE_MOST = 256 };

/* If a user-defined robot needs more memory than the library's robots, compile this file with these
 * macros set to the device_size and input_size of its driver, in bytes. */
#ifndef FROB_DEVICE_MOST
#define FROB_DEVICE_MOST 1
#endif
#ifndef FROB_INPUT_MOST
#define FROB_INPUT_MOST 1
#endif

static union {
    struct frob_pioneer pioneer;
    struct frob_scout scout;
    struct frob_create create;
    unsigned char own[FROB_DEVICE_MOST];
} device;

union robot_input {
    struct frob_pioneer_input pioneer;
    struct frob_scout_input scout;
    struct frob_create_input create;
    unsigned char own[FROB_INPUT_MOST];
};

/* The robot's input struct, followed by the operator's console. */
static union {
    union robot_input robot;
    unsigned char bytes[sizeof(union robot_input) + CONSOLE_MOST];
} input;

/* The robot's output struct, followed by the result of a task. */
static union {
    double aligned;
    unsigned char bytes[FROB_OUTPUT_MOST + RESULT_MOST];
} output;

static const struct frob_driver *driver;
static struct frob_serial line;
static struct frob_clock time_;
static double settings[SETTINGS_MOST];
static struct frob_robot robot;
static int64_t due_ns;            /* time of the next instant; 0: as soon as the robot is ready */
static int64_t before_ns;         /* time of the last instant; 0: none yet */
static volatile int64_t alive_ns; /* start time of the last round of the loop; 0: not running */
static int64_t stopped_ns;
static struct loop_counts counts;

/* The driver of the program's user-defined robot; NULL if the robot is not user-defined. frobc
 * generates the definition. */
extern const struct frob_driver *const frob_own_driver;

static const struct frob_driver *find_driver(void)
{
    static const struct frob_driver *const drivers[] = { &frob_pioneer_driver, &frob_scout_driver,
                                                         &frob_create_driver };
    if (frob_own_driver != NULL && strcmp(frob_own_driver->robot, frob_program.robot) == 0)
        return frob_own_driver;
    for (size_t i = 0; i < sizeof drivers / sizeof drivers[0]; i++)
        if (strcmp(drivers[i]->robot, frob_program.robot) == 0)
            return drivers[i];
    return NULL;
}

static bool is_of(const struct frob_driver *d)
{
    return d != NULL && frob_program.input_size >= d->input_size &&
           frob_program.output_size >= d->output_size &&
           frob_program.output_size <= sizeof output && d->setting_count <= SETTINGS_MOST;
}

static bool fits(const struct frob_driver *d)
{
    return d->device_size <= sizeof device && frob_program.input_size <= sizeof input;
}

uint32_t loop_line_rate(void)
{
    const struct frob_driver *d = find_driver();
    return d != NULL ? d->rate : 0;
}

static void connect(void)
{
    due_ns = 0;
    frob_robot_start(&robot, driver, &device, settings, &line, &time_, PATIENCE_NS);
}

const char *loop_start(const struct frob_serial *serial, const struct frob_clock *clock)
{
    const struct frob_driver *found = find_driver();
    if (!is_of(found))
        return "this board has no driver for the program's robot";
    if (!fits(found))
        return "not enough memory for the robot's driver: compile loop.c with a larger "
               "FROB_DEVICE_MOST or FROB_INPUT_MOST";
    /* Checks the arithmetic of the program, and that of this host, because the host limits the
     * program's commands. */
    if ((frob_program.arithmetic() | frob_arithmetic_faults()) != 0)
        return "this program must not drive a robot, because its arithmetic is not IEEE 754: "
               "compile it with -ffp-contract=off and without -ffast-math";
    for (size_t i = 0; i < found->setting_count; i++)
        settings[i] = found->settings[i].initial;
    line = *serial;
    time_ = *clock;
    driver = found;
    frob_program.reset(frob_program_state, frob_program.default_params);
    frob_console_start(&frob_program, &input);
    connect();
    return NULL;
}

/* Stops the robot. The line is the only data that this function shares with the stuck loop. If
 * the stop command interrupts a packet, the robot drops that packet. */
void loop_watch(int64_t now_ns)
{
    if (alive_ns == 0 || now_ns - alive_ns <= PATIENCE_NS || now_ns - stopped_ns < STOP_PERIOD_NS)
        return;
    if (stopped_ns < alive_ns)
        counts.late++;
    stopped_ns = now_ns;
    frob_robot_halt(&robot);
}

void loop_stop(void)
{
    if (driver != NULL)
        frob_robot_halt(&robot);
}

/* Runs a step and sends its command, unless the step took so long that the command is outdated. */
static void instant(int64_t now)
{
    const int64_t dt_ns = before_ns == 0 ? 0 : now - before_ns;
    if (!frob_program.is_valid(frob_program_state)) {
        counts.damaged++;
        frob_robot_halt(&robot);
        return;
    }
    frob_robot_sense(&robot, &input);
    memset(&output, 0, sizeof output);
    frob_program.step(frob_program_state, frob_program.default_params, dt_ns, (double)dt_ns / 1e9,
                      &input, &output);
    frob_console_clear(&frob_program, &input);
    before_ns = now;
    counts.steps++;
    if (frob_now_ns(&time_) - now <= PATIENCE_NS)
        frob_robot_command(&robot, &output);
}

int64_t loop_round(void)
{
    int64_t now = frob_now_ns(&time_), until = now + PERIOD_NS;
    enum frob_robot_state state;
    alive_ns = now;
    state = frob_robot_poll(&robot);
    if (state == FROB_ROBOT_FAILED) {
        connect(); /* retries forever */
    } else if (state != FROB_ROBOT_READY) {
        due_ns = 0;
    } else if (now >= due_ns) {
        if (due_ns == 0)
            due_ns = now;
        counts.overruns += (uint32_t)((now - due_ns) / PERIOD_NS);
        due_ns += ((now - due_ns) / PERIOD_NS + 1) * PERIOD_NS;
        instant(now);
    }
    if (due_ns != 0 && due_ns < until)
        until = due_ns;
    if (frob_robot_due_ns(&robot) < until)
        until = frob_robot_due_ns(&robot);
    return until;
}

void *loop_input(void)
{
    return &input;
}

struct loop_counts loop_count(void)
{
    counts.stale = robot.stale;
    counts.connections = robot.connections;
    return counts;
}
