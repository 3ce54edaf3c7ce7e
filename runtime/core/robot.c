#include "core/robot.h"

#include <math.h>
#include <string.h>

/* Interval at which the stop command is repeated while the robot is at rest. */
#define STOP_PERIOD_NS INT64_C(100000000)

static double *drive(const struct frob_driver *driver, void *output, size_t i)
{
    return (double *)(void *)((char *)output + driver->drives[i]);
}

static void rest(const struct frob_driver *driver, void *output)
{
    for (size_t i = 0; i < driver->drive_count; i++)
        *drive(driver, output, i) = 0.0;
}

bool frob_robot_limit(const struct frob_driver *driver, const void *device, void *output)
{
    bool changed = false;
    for (size_t i = 0; i < driver->drive_count; i++) {
        if (!isfinite(*drive(driver, output, i))) {
            rest(driver, output);
            return true;
        }
    }
    for (size_t i = 0; i < driver->drive_count; i++) {
        double *x = drive(driver, output, i);
        double most = driver->most(device, i);
        if (*x > most || *x < -most) {
            *x = *x > 0.0 ? most : -most;
            changed = true;
        }
    }
    return changed;
}

void frob_robot_start(struct frob_robot *robot, const struct frob_driver *driver, void *device,
                      const double *settings, const struct frob_serial *serial,
                      const struct frob_clock *clock, int64_t patience_ns)
{
    uint32_t connections = robot->connections, stale = robot->stale;
    memset(robot, 0, sizeof *robot);
    robot->driver = driver;
    robot->device = device;
    robot->serial = *serial;
    robot->clock = *clock;
    robot->patience_ns = patience_ns;
    robot->state = FROB_ROBOT_CONNECTING;
    robot->status = FROB_BUSY_CONNECTING;
    robot->at_rest = robot->rests_first = true;
    robot->polled_ns = robot->counts_from_ns = INT64_MIN;
    robot->given_ns = INT64_MAX;
    robot->connections = connections;
    robot->stale = stale;
    driver->start(device, settings, &robot->serial, &robot->clock);
}

/* Repeats the stop command if the robot is at rest and the command is due. */
static enum frob_status keep_still(struct frob_robot *robot)
{
    int64_t now = frob_now_ns(&robot->clock);
    if (!robot->at_rest || now < robot->stop_due_ns)
        return FROB_OK;
    robot->stop_due_ns = now + STOP_PERIOD_NS;
    return robot->driver->stop(robot->device);
}

static bool is_fresh(const struct frob_robot *robot)
{
    int64_t sensed = robot->driver->sensed_ns(robot->device);
    return sensed != INT64_MIN && sensed >= robot->counts_from_ns &&
           frob_now_ns(&robot->clock) - sensed <= robot->patience_ns;
}

/* Handles readings that are too old: stops the robot immediately. */
static void become_stale(struct frob_robot *robot)
{
    robot->stale++;
    robot->state = FROB_ROBOT_STALE;
    robot->at_rest = robot->rests_first = true;
    robot->stop_due_ns = INT64_MIN;
}

/* Handles a gap between two polls. After a gap, the age of the readings on the line is unknown, and
 * more outdated readings may follow. The driver's poll would begin by sending a pending command, so
 * this function stops the robot first. */
static enum frob_status note_gap(struct frob_robot *robot)
{
    int64_t now = frob_now_ns(&robot->clock);
    bool is_gap = robot->polled_ns != INT64_MIN && now - robot->polled_ns > robot->patience_ns &&
                  robot->state != FROB_ROBOT_CONNECTING;
    robot->polled_ns = now;
    if (!is_gap)
        return FROB_OK;
    robot->counts_from_ns = now + robot->patience_ns;
    if (robot->state != FROB_ROBOT_STALE)
        become_stale(robot);
    return keep_still(robot);
}

/* Reports that the driver has given up or has lost its line. Unless the line is lost, sends a last
 * stop command, which may still get through. */
static enum frob_robot_state failed(struct frob_robot *robot, enum frob_status status)
{
    if (robot->state != FROB_ROBOT_FAILED && status != FROB_LOST)
        robot->driver->stop(robot->device);
    robot->status = status;
    robot->state = FROB_ROBOT_FAILED;
    return robot->state;
}

enum frob_robot_state frob_robot_poll(struct frob_robot *robot)
{
    enum frob_status status;
    if (robot->state == FROB_ROBOT_FAILED)
        return robot->state;
    status = note_gap(robot);
    if (status != FROB_OK)
        return failed(robot, status);
    status = robot->driver->poll(robot->device);
    if (status == FROB_BUSY_CONNECTING) {
        robot->status = status;
        return robot->state;
    }
    if (status != FROB_OK)
        return failed(robot, status);
    if (robot->state == FROB_ROBOT_CONNECTING)
        robot->connections++;
    if (is_fresh(robot)) {
        robot->state = FROB_ROBOT_READY;
    } else if (robot->state != FROB_ROBOT_STALE) {
        become_stale(robot);
    }
    status = keep_still(robot);
    if (status != FROB_OK)
        return failed(robot, status);
    robot->status = FROB_OK;
    return robot->state;
}

int64_t frob_robot_due_ns(const struct frob_robot *robot)
{
    int64_t due = robot->driver->due_ns(robot->device), other = INT64_MAX;
    if (robot->state == FROB_ROBOT_READY)
        other = robot->driver->sensed_ns(robot->device) + robot->patience_ns + 1;
    if (due > other)
        due = other;
    if (robot->state != FROB_ROBOT_CONNECTING && robot->at_rest && robot->stop_due_ns < due)
        due = robot->stop_due_ns;
    return due;
}

void frob_robot_sense(struct frob_robot *robot, void *input)
{
    robot->driver->sense(robot->device, input);
    robot->given_ns = robot->driver->sensed_ns(robot->device);
}

enum frob_status frob_robot_command(struct frob_robot *robot, const void *output)
{
    const void *commanded = output;
    const int64_t given_ns = robot->given_ns;
    robot->given_ns = INT64_MAX;
    if (robot->state != FROB_ROBOT_READY)
        return robot->status;
    if (frob_now_ns(&robot->clock) - given_ns > robot->patience_ns) {
        become_stale(robot);
        return frob_robot_halt(robot);
    }
    if (robot->driver->drive_count > 0) {
        void *limited = robot->limited.bytes;
        memcpy(limited, output, robot->driver->output_size);
        frob_robot_limit(robot->driver, robot->device, limited);
        if (robot->rests_first)
            rest(robot->driver, limited);
        commanded = limited;
    }
    robot->status = robot->driver->command(robot->device, commanded);
    if (robot->status == FROB_OK)
        robot->at_rest = robot->rests_first = false;
    else
        failed(robot, robot->status);
    return robot->status;
}

enum frob_status frob_robot_halt(struct frob_robot *robot)
{
    robot->at_rest = robot->rests_first = true;
    robot->halted_ns = frob_now_ns(&robot->clock);
    robot->stop_due_ns = robot->halted_ns + STOP_PERIOD_NS;
    return robot->driver->stop(robot->device);
}

bool frob_robot_stands(const struct frob_robot *robot)
{
    return robot->driver->stands != NULL && robot->at_rest &&
           robot->driver->sensed_ns(robot->device) > robot->halted_ns &&
           robot->driver->stands(robot->device);
}

void frob_robot_close(struct frob_robot *robot)
{
    robot->driver->close(robot->device);
}
