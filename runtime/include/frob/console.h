/* frob/console.h -- the operator's console, as part of a robot's input.
 *
 * Keys typed on the host set the input field `key`. The program's table (`console`) lists the
 * buttons, knobs, toggles and map that the program uses; their values follow the robot's struct in
 * the input. A host calls frob_console_start once, and frob_console_clear after each instant. In
 * between it may call frob_console_touch at any time; the program sees the change at the next
 * instant. */
#ifndef FROB_CONSOLE_H
#define FROB_CONSOLE_H

#include <frob/program.h>

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Sets the key event of an instant: a character code, or -1 for none. Does nothing if the program's
 * input has no field for keys. */
void frob_console_key(const struct frob_program *program, void *input, int32_t key);

/* Initializes the console: no event occurs, no button is held down, and knobs and toggles have
 * their initial values. */
void frob_console_start(const struct frob_program *program, void *input);

/* Returns the index of the control with this label, or `control_count` if there is none. */
size_t frob_console_find(const struct frob_program *program, const char *label);

/* Returns whether this part of the input belongs to the console. */
bool frob_console_is_on(const struct frob_program *program, const struct frob_value *value);

/* Operates the control with index `control`:
 *   a button   is pressed
 *   a hold     is held down from now on if x is not 0, and released otherwise
 *   a knob     is turned to x, in base units, clamped to its range
 *   a toggle   is on from now on if x is not 0, and off otherwise
 *   the map    is clicked at x, y, in metres, in the odometry frame
 * Returns false and changes nothing if there is no such control, if it is a camera, or if a number
 * is NaN. */
bool frob_console_touch(const struct frob_program *program, void *input, size_t control, double x,
                        double y);

/* Ends the instant: removes all events. */
void frob_console_clear(const struct frob_program *program, void *input);

/* Releases all held buttons, for example when the operator has disconnected. */
void frob_console_release(const struct frob_program *program, void *input);

#ifdef __cplusplus
}
#endif
#endif
