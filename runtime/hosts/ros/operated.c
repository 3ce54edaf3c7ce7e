#include "operated.h"

#include <frob/console.h>

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "acceptance.h"
#include "device.h"
#include "readings.h"

/* The program does not run if the readings are older than this. */
#define RUNNING_NS INT64_C(500000000)

static const struct frob_program *program;

void operated_of(const struct frob_program *of)
{
    program = of;
}

void operated_start(struct operated *operated)
{
    operated->joystick.received_ns = operated->map.received_ns = INT64_MIN;
}

void operated_name(struct operated *operated, const struct ros_started *names)
{
    snprintf(operated->joystick.name, sizeof operated->joystick.name, "%s", names->joy);
    snprintf(operated->map.name, sizeof operated->map.name, "%s", names->click);
}

void operated_topic(const struct frob_control *button, char *name, size_t room)
{
    static const char start[] = "~/buttons/";
    size_t length = sizeof start - 1;
    snprintf(name, room, "%s%s", start, isdigit((unsigned char)button->label[0]) ? "_" : "");
    length = strlen(name);
    for (const char *c = button->label; *c != '\0' && length + 1 < room; c++)
        name[length++] = (unsigned char)*c < 128 && isalnum((unsigned char)*c) ? *c : '_';
    name[length] = '\0';
}

/* ---- Messages */

static bool is_running(const struct ros_device *d)
{
    const int64_t since = ros_placed_ns(d, d->sensed_ns);
    if (!d->managed.is_active)
        return false;
    /* A node with its own topics does not need odometry. */
    return d->take_other != NULL ||
           (since != INT64_MIN && frob_now_ns(&d->clock) - since < RUNNING_NS);
}

/* Returns whether the program is running. If not, warns that the action on this control is
 * ignored. */
static bool sees(const struct ros_device *d, const struct frob_control *control)
{
    if (is_running(d))
        return true;
    if (control->kind == FROB_MAP)
        fprintf(stderr, "warning: a click on the map");
    else
        fprintf(stderr, "warning: a press of the button `%s`", control->label);
    fprintf(stderr, " is ignored, because the program is not running\n");
    return false;
}

void operated_take_joy(struct ros_device *d, const struct ros_joy *message)
{
    struct operated *o = &d->operated;
    const char *bad = joy_check(message, program, o->why, sizeof o->why);
    int64_t taken_ns;
    if (ros_accepts(d, &o->joystick, bad, message->origin.stamp_ns, message->origin.arrived_ns,
                    &taken_ns))
        joy_take(&o->joy, message, program, frob_now_ns(&d->clock));
}

void operated_take_press(struct ros_device *d, const struct ros_press *press)
{
    if (press->control < ROS_CONTROLS_MOST && press->control < program->control_count &&
        sees(d, &program->console[press->control]))
        d->operated.is_pressed[press->control] = true;
}

void operated_take_click(struct ros_device *d, const struct ros_click *message)
{
    struct operated *o = &d->operated;
    const char *bad = NULL;
    int64_t taken_ns;
    if (message->placing.fate != ROS_FOUND) {
        ros_explain_frame(&message->placing, "", "choose another fixed frame in rviz", o->why_not,
                          sizeof o->why_not);
        bad = o->why_not;
    } else if (!isfinite(message->x_m) || !isfinite(message->y_m)) {
        bad = "its position is not a finite number";
    }
    if (!ros_accepts(d, &o->map, bad, message->origin.stamp_ns, message->origin.arrived_ns,
                     &taken_ns) ||
        message->origin.control >= program->control_count ||
        !sees(d, &program->console[message->origin.control]))
        return;
    o->x_m = message->x_m;
    o->y_m = message->y_m;
    o->is_clicked = true;
}

/* ---- The program's input */

void operated_give(struct operated *o, void *input, int64_t now_ns)
{
    if (program == NULL)
        return;
    for (size_t i = 0; i < program->control_count; i++) {
        if (i < ROS_CONTROLS_MOST && o->is_pressed[i])
            frob_console_touch(program, input, i, 1.0, 0.0);
        if (program->console[i].kind == FROB_MAP && o->is_clicked)
            frob_console_touch(program, input, i, o->x_m, o->y_m);
    }
    memset(o->is_pressed, 0, sizeof o->is_pressed);
    o->is_clicked = false;
    joy_give(&o->joy, program, input, now_ns);
}
