/* joy.h -- the joystick of the topic `joy`, which operates controls of the program's console.
 *
 * The user chooses the controls: `--set joy.LABEL=NUMBER` assigns a button of the joystick to a
 * button or a hold of the console, or an axis to a knob. An axis at rest, at 0, is the knob's initial
 * value; its ends, -1 and 1, are the ends of the knob's range. */
#ifndef FROB_HOST_ROS_JOY_H
#define FROB_HOST_ROS_JOY_H

#include <frob/program.h>

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "messages.h"

/* If the joystick is silent for this time, it no longer operates its controls. */
#define JOY_SILENCE_NS INT64_C(500000000)

/* Takes the settings of the joystick out of a command line. Returns the new number of arguments, or -1
 * after an error, which it prints on standard error. */
int joy_settings(int argc, char **argv, const struct frob_program *program);

/* Returns whether a joystick operates any control. */
bool joy_is_used(void);

/* The state of the joystick. */
struct joy {
    bool heard;
    int64_t heard_ns;                /* when the newest message arrived */
    double value[ROS_CONTROLS_MOST]; /* of each control: from 0 to 1 for buttons, or of the knob */
    bool is_pressed[ROS_CONTROLS_MOST]; /* whether a button was pressed and the program has not read
                                         * it */
    double given[ROS_CONTROLS_MOST];    /* the newest value that the program has received */
    bool is_given[ROS_CONTROLS_MOST];
};

/* Checks a message. Returns NULL, or the reason why it is ignored, in `why`. */
const char *joy_check(const struct ros_joy *message, const struct frob_program *program, char *why,
                      size_t room);

/* Handles a message that joy_check accepts. */
void joy_take(struct joy *joy, const struct ros_joy *message, const struct frob_program *program,
              int64_t now_ns);

/* Operates the controls for an instant. */
void joy_give(struct joy *joy, const struct frob_program *program, void *input, int64_t now_ns);

#endif
