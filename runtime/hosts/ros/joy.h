/* joy.h -- the joystick on the topic `joy`, which operates controls on the program's console.
 *
 * The user chooses the controls: `--set joy.LABEL=NUMBER` assigns a joystick button to a button or
 * hold on the console, or an axis to a knob. At rest (0), an axis sets the knob to its initial
 * value; at its ends (-1 and 1), to the ends of the knob's range. */
#ifndef FROB_HOST_ROS_JOY_H
#define FROB_HOST_ROS_JOY_H

#include <frob/program.h>

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "messages.h"

/* If no message arrives for this long, the joystick no longer operates its controls. */
#define JOY_SILENCE_NS INT64_C(500000000)

/* Removes the settings of the joystick from a command line, and applies them. Returns the new
 * number of arguments, or -1 after printing an error on standard error. */
int joy_settings(int argc, char **argv, const struct frob_program *program);

/* Returns whether a joystick operates any control. */
bool joy_is_used(void);

/* The state of the joystick. */
struct joy {
    bool heard;
    int64_t heard_ns;                   /* time at which the newest message arrived */
    double value[ROS_CONTROLS_MOST];    /* for each control: 0 or 1 for a button, or the knob's
                                      * setting */
    bool is_pressed[ROS_CONTROLS_MOST]; /* for each button, whether a press is still to be passed to
                                         * the program */
    double given[ROS_CONTROLS_MOST];    /* for each control, the newest value passed to the
                                         * program */
    bool is_given[ROS_CONTROLS_MOST];
};

/* Checks a message. Returns NULL, or the reason why it is ignored; `why` is a buffer for the
 * reason. */
const char *joy_check(const struct ros_joy *message, const struct frob_program *program, char *why,
                      size_t room);

/* Handles a message that joy_check accepts. */
void joy_take(struct joy *joy, const struct ros_joy *message, const struct frob_program *program,
              int64_t now_ns);

/* Applies the joystick's state to the program's controls at an instant. */
void joy_give(struct joy *joy, const struct frob_program *program, void *input, int64_t now_ns);

#endif
