/* operated.h -- handles what other nodes do on the program's console: they press its buttons, click
 * on its map, or operate it with a joystick.
 *
 * Actions are ignored while the program does not run, because they would be outdated when it
 * continues. */
#ifndef FROB_HOST_ROS_OPERATED_H
#define FROB_HOST_ROS_OPERATED_H

#include <frob/program.h>

#include <stdbool.h>
#include <stdint.h>

#include "joy.h"
#include "messages.h"
#include "topic_state.h"

struct ros_device;

struct operated {
    struct ros_topic joystick, map;
    struct joy joy;
    bool is_pressed[ROS_CONTROLS_MOST]; /* whether a button was pressed and the program has not read
                                         * the press yet */
    bool is_clicked;                    /* whether the map was clicked and the program has not read
                                         * the click yet */
    double x_m, y_m;
    char why[ROS_REASON];     /* the reason why messages from the joystick are ignored */
    char why_not[ROS_REASON]; /* the reason why clicks are ignored */
};

/* Sets the program whose console is operated. */
void operated_of(const struct frob_program *program);

void operated_start(struct operated *operated);
void operated_name(struct operated *operated, const struct ros_started *names);

void operated_take_joy(struct ros_device *device, const struct ros_joy *message);
void operated_take_press(struct ros_device *device, const struct ros_press *press);
void operated_take_click(struct ros_device *device, const struct ros_click *message);

/* Sets the program's input for an instant to the state of the controls. */
void operated_give(struct operated *operated, void *input, int64_t now_ns);

/* Writes the name of a button's topic, such as `~/buttons/go`: its last part is the label, with an
 * underscore in place of each character that is not a letter or digit, and one in front if the
 * label starts with a digit. */
void operated_topic(const struct frob_control *button, char *name, size_t room);

#endif
