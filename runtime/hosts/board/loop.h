/* board/loop.h -- the main loop of a host without an operating system: serves the robot's line,
 * runs the program's step at a fixed rate with measured dt, and stops the robot if necessary. A
 * board's main function opens the line and the clock, and calls
 *
 *   loop_start(&serial, &clock);
 *   for (;;)
 *       wait until bytes arrive or loop_round();
 *
 * There is no second process to supervise the loop. Instead, a timer interrupt must call
 * loop_watch. If a step takes longer than 0.2 s, or the loop is stuck elsewhere, loop_watch sends a
 * stop command ten times a second until the loop runs again. */
#ifndef FROB_HOST_BOARD_LOOP_H
#define FROB_HOST_BOARD_LOOP_H

#include <stdint.h>

#include "hal/clock.h"
#include "hal/serial.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Starts to connect to the program's robot; both arguments must stay valid. Returns NULL, or a line
 * of text that says why the program must not start: there is no driver for the robot, there is not
 * enough memory for it (FROB_DEVICE_MOST and FROB_INPUT_MOST in loop.c), or the arithmetic of this
 * host does not meet the requirements of programs (<frob/arithmetic.h>). */
const char *loop_start(const struct frob_serial *serial, const struct frob_clock *clock);

/* Returns the initial bit rate of the robot's line; 0 if there is no driver. */
uint32_t loop_line_rate(void);

/* Runs one round: handles received bytes, sends commands that are due, and may run a step. Returns
 * the time at which to call it again if no byte arrives before then. */
int64_t loop_round(void);

/* Call this from a timer interrupt, at least ten times a second. */
void loop_watch(int64_t now_ns);

/* Sends a stop command to the robot, whatever the loop is doing. For fault handlers. */
void loop_stop(void);

/* Returns the program's input, for <frob/console.h>. Use it to operate the console with the board's
 * buttons and dials. Changes take effect at the next step. Change the input only between rounds,
 * not in an interrupt. */
void *loop_input(void);

struct loop_counts {
    uint32_t steps, overruns, late, stale, connections;
    uint32_t damaged; /* number of instants without a step, because the program's state was not
                       * valid; the robot stays at rest until the board restarts */
};

struct loop_counts loop_count(void);

#ifdef __cplusplus
}
#endif
#endif
