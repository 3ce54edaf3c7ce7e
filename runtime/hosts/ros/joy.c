#include "joy.h"

#include <frob/console.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bumpers.h"

static const char setting[] = "joy.";

/* For each control, 1 more than the number of its button or axis; 0 if it has none. */
static uint32_t uses[ROS_CONTROLS_MOST];
static bool is_used;

/* ---- Settings */

static bool is_hold(const struct frob_control *control)
{
    return control->kind == FROB_HOLD && bumpers_topic(control) == NULL;
}

static bool is_operated(const struct frob_control *control)
{
    return is_hold(control) || control->kind == FROB_KNOB || control->kind == FROB_BUTTON;
}

/* Reports that the joystick cannot operate a control, and lists the controls that it can
 * operate. */
static void refuse(const struct frob_program *program, const char *label, size_t length)
{
    const char *separator = "its buttons and knobs are";
    bool has_any = false;
    fprintf(stderr, "error: a joystick cannot operate `%.*s`: ", (int)length, label);
    for (size_t i = 0; i < program->control_count; i++) {
        const struct frob_control *control = &program->console[i];
        if (control->kind == FROB_TOGGLE && strlen(control->label) == length &&
            strncmp(control->label, label, length) == 0) {
            fprintf(stderr, "it is a toggle, which is a parameter of the node: add `--ros-args -p "
                            "NAME:=true`, or use `ros2 param set`\n");
            return;
        }
    }
    fprintf(stderr, "%s ", program->name);
    for (size_t i = 0; i < program->control_count; i++) {
        if (!is_operated(&program->console[i]))
            continue;
        fprintf(stderr, has_any ? ", `%s`" : "has no button or knob with this name; %s `%s`",
                has_any ? program->console[i].label : separator, program->console[i].label);
        has_any = true;
    }
    fprintf(stderr, has_any ? "\n" : "has no buttons or knobs\n");
}

/* Reads LABEL=NUMBER. */
static bool assign(const struct frob_program *program, const char *text)
{
    const char *equals = strrchr(text, '=');
    const size_t length = equals != NULL ? (size_t)(equals - text) : strlen(text);
    size_t i = 0;
    char *end = NULL;
    long number;
    while (i < program->control_count &&
           !(is_operated(&program->console[i]) && strlen(program->console[i].label) == length &&
             strncmp(program->console[i].label, text, length) == 0))
        i++;
    if (i == program->control_count || i >= ROS_CONTROLS_MOST) {
        refuse(program, text, length);
        return false;
    }
    number = equals != NULL ? strtol(equals + 1, &end, 10) : -1;
    if (equals == NULL || end == equals + 1 || *end != '\0' || number < 0 ||
        number >= ROS_JOY_MOST) {
        fprintf(stderr,
                "error: `%s%.*s` must be the number of %s of the joystick, from 0 to %d: write "
                "`--set \"%s%.*s=0\"`\n",
                setting, (int)length, text,
                program->console[i].kind == FROB_KNOB ? "an axis" : "a button", ROS_JOY_MOST - 1,
                setting, (int)length, text);
        return false;
    }
    uses[i] = (uint32_t)number + 1;
    is_used = true;
    return true;
}

/* Reports hold buttons that nothing operates, because the program would never see them pressed. */
static void tell_idle(int argc, char **argv, const struct frob_program *program)
{
    for (int i = 1; i < argc; i++)
        if (strcmp(argv[i], "--control") == 0 || strcmp(argv[i], "--help") == 0)
            return;
    for (size_t i = 0; i < program->control_count && i < ROS_CONTROLS_MOST; i++)
        if (is_hold(&program->console[i]) && uses[i] == 0)
            fprintf(stderr,
                    "warning: nothing can press the button `%s`: add `--set \"%s%s=NUMBER\"` for a "
                    "joystick button, or `--view --control`\n",
                    program->console[i].label, setting, program->console[i].label);
}

int joy_settings(int argc, char **argv, const struct frob_program *program)
{
    int count = 0;
    bool is_ours = true;
    for (int i = 0; i < argc; i++) {
        is_ours = is_ours && strcmp(argv[i], "--ros-args") != 0 && strcmp(argv[i], "--viewer") != 0;
        if (is_ours && i > 0 && i + 1 < argc && strcmp(argv[i], "--set") == 0 &&
            strncmp(argv[i + 1], setting, sizeof setting - 1) == 0) {
            if (!assign(program, argv[++i] + sizeof setting - 1))
                return -1;
        } else {
            argv[count++] = argv[i];
        }
    }
    tell_idle(count, argv, program);
    return count;
}

bool joy_is_used(void)
{
    return is_used;
}

/* ---- Messages */

const char *joy_check(const struct ros_joy *m, const struct frob_program *program, char *why,
                      size_t room)
{
    for (size_t i = 0; i < program->control_count && i < ROS_CONTROLS_MOST; i++) {
        const bool is_axis = program->console[i].kind == FROB_KNOB;
        const uint32_t count = is_axis ? m->axis_count : m->button_count;
        if (uses[i] == 0)
            continue;
        if (uses[i] > count) {
            snprintf(why, room,
                     "`%s%s=%u` needs %u %s, but the joystick has %u: change this setting", setting,
                     program->console[i].label, uses[i] - 1, uses[i],
                     uses[i] > 1 ? (is_axis ? "axes" : "buttons") : (is_axis ? "axis" : "button"),
                     count);
            return why;
        }
        if (is_axis && !isfinite(m->axes[uses[i] - 1]))
            return "an axis is not a finite number";
    }
    return NULL;
}

/* Returns the value of a knob for the position of an axis. */
static double knob_at(const struct frob_control *control, double axis)
{
    const double end = axis < 0.0 ? control->least : control->most;
    const double part = fabs(axis) < 1.0 ? fabs(axis) : 1.0;
    return control->first + part * (end - control->first);
}

void joy_take(struct joy *joy, const struct ros_joy *m, const struct frob_program *program,
              int64_t now_ns)
{
    const bool is_new = !joy->heard || now_ns - joy->heard_ns > JOY_SILENCE_NS;
    for (size_t i = 0; i < program->control_count && i < ROS_CONTROLS_MOST; i++) {
        const struct frob_control *control = &program->console[i];
        double value;
        if (uses[i] == 0)
            continue;
        if (control->kind == FROB_KNOB)
            value = knob_at(control, (double)m->axes[uses[i] - 1]);
        else
            value = m->is_down[uses[i] - 1] ? 1.0 : 0.0;
        /* A button that is already down in the first message does not count as a new press. */
        if (control->kind == FROB_BUTTON && !is_new && value > joy->value[i])
            joy->is_pressed[i] = true;
        joy->value[i] = value;
    }
    joy->heard = true;
    joy->heard_ns = now_ns;
}

/* Passes a value to the program only if it has changed, because the control may also be operated in
 * other ways. */
static void pass(struct joy *joy, size_t i, double value, const struct frob_program *program,
                 void *input)
{
    if (joy->is_given[i] && !(value < joy->given[i]) && !(value > joy->given[i]))
        return;
    joy->is_given[i] = true;
    joy->given[i] = value;
    frob_console_touch(program, input, i, value, 0.0);
}

void joy_give(struct joy *joy, const struct frob_program *program, void *input, int64_t now_ns)
{
    const bool is_silent = now_ns - joy->heard_ns > JOY_SILENCE_NS;
    for (size_t i = 0; joy->heard && i < program->control_count && i < ROS_CONTROLS_MOST; i++) {
        const struct frob_control *control = &program->console[i];
        if (uses[i] == 0)
            continue;
        if (control->kind == FROB_BUTTON) {
            if (joy->is_pressed[i] && !is_silent)
                frob_console_touch(program, input, i, 1.0, 0.0);
            joy->is_pressed[i] = false;
        } else {
            const double rest = control->kind == FROB_KNOB ? control->first : 0.0;
            pass(joy, i, is_silent ? rest : joy->value[i], program, input);
        }
    }
}
