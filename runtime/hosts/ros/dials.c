#include "dials.h"

#include <frob/console.h>

#include <string.h>

#include "device.h"

/* Handles a change to one of the node's parameters. Ignores the initial values of a restarted node,
 * because the program's current values still apply. */
void ros_take_touch(struct ros_device *d, const struct ros_touch *touch)
{
    struct ros_dial *dial;
    if (touch->control >= ROS_CONTROLS_MOST || (touch->is_initial && d->gave))
        return;
    dial = &d->dials[touch->control];
    dial->value = touch->value;
    dial->is_set = dial->is_known = true;
}

static double dial_value(const struct frob_control *control, const void *input)
{
    const char *at = (const char *)input + control->value->offset;
    double number;
    float single;
    bool truth;
    if (control->kind == FROB_TOGGLE) {
        memcpy(&truth, at, sizeof truth);
        return truth ? 1.0 : 0.0;
    }
    if (control->value->kind == FROB_SINGLE) {
        memcpy(&single, at, sizeof single);
        return (double)single;
    }
    memcpy(&number, at, sizeof number);
    return number;
}

static void tell_node(const struct ros_device *d, size_t control, double value)
{
    struct ros_touch touch;
    memset(&touch, 0, sizeof touch);
    touch.head.size = (uint32_t)sizeof touch;
    touch.head.kind = ROS_TOUCH;
    touch.control = (uint32_t)control;
    touch.value = value;
    /* If the line is lost, poll detects it. */
    d->serial.operations->write(d->serial.port, (const uint8_t *)&touch, sizeof touch);
}

/* Applies the knob and toggle values that other nodes have set, and sends the node those that the
 * operator has set here. */
void ros_give_dials(struct ros_device *d, const struct frob_program *program, void *input)
{
    for (size_t i = 0; i < program->control_count && i < ROS_CONTROLS_MOST; i++) {
        const struct frob_control *control = &program->console[i];
        struct ros_dial *dial = &d->dials[i];
        double value;
        if (control->kind != FROB_KNOB && control->kind != FROB_TOGGLE)
            continue;
        if (dial->is_set)
            frob_console_touch(program, input, i, dial->value, 0.0);
        value = dial_value(control, input);
        if (!dial->is_set && (!dial->is_known || value < dial->value || value > dial->value))
            tell_node(d, i, value);
        dial->is_set = false;
        dial->is_known = true;
        dial->value = value;
    }
    d->gave = true;
}
