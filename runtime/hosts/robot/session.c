#include "session.h"

#include <stdio.h>
#include <string.h>

#include "hal/posix/clock.h"

/* Returns a setting of the driver by name; NULL if it has no such setting. */
static const double *setting(const struct run *s, const char *name)
{
    for (size_t i = 0; i < s->driver->setting_count; i++) {
        if (strcmp(s->driver->settings[i].name, name) == 0)
            return &s->options->settings[i];
    }
    return NULL;
}

void session_begin(struct run *s)
{
    struct frob_serial serial = frob_posix_serial(&s->line.port);
    frob_robot_start(&s->robot, s->driver, s->device, s->options->settings, &serial,
                     &frob_posix_clock, s->patience_ns);
    guards_start(&s->guards, &s->robot, s->patience_ns, s->controller.socket);
    s->scheduled = false;
    instants_restart(&s->instants);
}

static void leave_line(struct run *s)
{
    guards_end(&s->guards);
    line_close(&s->line);
    s->scheduled = false;
    if (s->lost_ns == 0)
        s->lost_ns = run_now_ns();
}

static const char *reason(const struct run *s, enum frob_status status)
{
    if (status == FROB_TIMEOUT)
        return "it does not answer";
    return s->line.opening != NULL ? s->line.opening->lost : "its line was disconnected";
}

/* Reports what was tried, and the likely cause. Bytes that are not an answer suggest a wrong rate
 * or another device. Silence may also mean that the power is off or that the cable is unplugged. */
static void nobody_answers(struct run *s)
{
    const char *device = s->line.device, *robot = s->driver->robot;
    const double *baud = setting(s, "baud");
    bool has_rate = !frob_posix_is_tcp(device) && (baud == NULL || *baud > 0.0);
    const char *its = has_rate && baud != NULL ? "check the line and its rate (`--set baud=...`)"
                                               : "check the line";
    char rate[40] = "";
    if (has_rate)
        snprintf(rate, sizeof rate, " at %.0f baud", baud != NULL ? *baud : s->driver->rate);
    if (s->line.port.heard)
        run_end(s, FAULT, "a device sends data on %s, but no %s answers%s: %s", device, robot, rate,
                its);
    else
        run_end(s, FAULT, "no %s answers on %s%s: turn it on, plug in its cable, and %s", robot,
                device, rate, its);
}

static void robot_failed(struct run *s)
{
    enum frob_status status = s->robot.status;
    if (status == FROB_REFUSED) {
        const char *who = s->driver->describe(s->device);
        run_end(s, FAULT, "cannot drive the robot%s%s", who[0] != '\0' ? ": " : "", who);
    } else if (s->robot.connections == 0 && s->line.opening == NULL) {
        nobody_answers(s);
    } else {
        run_tell(s, "lost the connection to the robot: %s", reason(s, status));
        if (s->options->reconnect_s <= 0.0)
            run_end(s, FAULT, "lost the connection to the robot: %s", reason(s, status));
        leave_line(s);
    }
}

void session_look_after(struct run *s)
{
    uint32_t connections = s->robot.connections;
    if (!line_is_open(&s->line) && line_reopen(&s->line, run_now_ns()))
        session_begin(s);
    if (line_is_open(&s->line) && frob_robot_poll(&s->robot) == FROB_ROBOT_FAILED)
        robot_failed(s);
    if (s->robot.connections > connections) {
        run_tell(s, "connected: %s", s->driver->describe(s->device));
        s->lost_ns = 0;
    }
    if (s->lost_ns != 0 && (double)(run_now_ns() - s->lost_ns) > s->options->reconnect_s * 1e9)
        run_end(s, FAULT, "lost the connection to the robot, and could not reconnect within %g s",
                s->options->reconnect_s);
}

bool session_is_ready(const struct run *s)
{
    return line_is_open(&s->line) && s->robot.state == FROB_ROBOT_READY;
}

void session_halt(struct run *s)
{
    if (line_is_open(&s->line))
        frob_robot_halt(&s->robot);
}
