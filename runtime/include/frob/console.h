/* frob/console.h -- the operator's console, as part of a robot's input.
 *
 * Keys that are typed on the host are its field `key`. The buttons, knobs, toggles and map
 * that a program asks for are in its table (`console`), and behind the robot's struct in its
 * input. A host starts them once, and clears them after each instant; in between it may touch
 * them whenever something happens: the program sees it at the next instant. */
#ifndef FROB_CONSOLE_H
#define FROB_CONSOLE_H

#include <frob/program.h>

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Sets the event of an instant: a key's character code, or -1 for none. Nothing
 * happens if the program's input has no such field. */
void frob_console_key(const struct frob_program *program, void *input, int32_t key);

/* The console that nobody has touched: no events, nothing held down, knobs and toggles as
 * they are at first. */
void frob_console_start(const struct frob_program *program, void *input);

/* The number of what has this label; the table's count if there is none. */
size_t frob_console_find(const struct frob_program *program, const char *label);

/* Whether the value, a part of the input, is on the console. */
bool frob_console_is_on(const struct frob_program *program, const struct frob_value *value);

/* What happens to number `control`:
 *   a button   is pressed
 *   a hold     is held down from now on if x is not 0, else let go of
 *   a knob     is turned to x, in base units, or to the limit next to it
 *   a toggle   is on from now on if x is not 0, else off
 *   the map    is clicked at x, y, in metres, where odometry has its origin
 * A number that is not on the console, a camera and a NaN change nothing; then the answer is
 * false. */
bool frob_console_touch(const struct frob_program *program, void *input, size_t control, double x,
                        double y);

/* The instant is over: no event occurs any more. */
void frob_console_clear(const struct frob_program *program, void *input);

/* Nothing is held down any more: the operator is gone. */
void frob_console_release(const struct frob_program *program, void *input);

#ifdef __cplusplus
}
#endif
#endif
