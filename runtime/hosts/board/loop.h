/* board/loop.h -- the loop of a host without an operating system: the robot's
 * line, the program's step at a fixed rate with measured dt, and what stops
 * the robot. A board's main function opens the line and the clock, and calls
 *
 *   loop_start(&serial, &clock);
 *   for (;;)
 *       wait until bytes arrive or loop_round();
 *
 * There is no second process here. What stands for the supervisor is
 * loop_watch, which the interrupt of a timer calls: when a step has not ended
 * within the patience, or the loop does not come round, it tells the robot to
 * stop, and again ten times a second, until the loop is back. */
#ifndef FROB_HOST_BOARD_LOOP_H
#define FROB_HOST_BOARD_LOOP_H

#include <stdint.h>

#include "hal/clock.h"
#include "hal/serial.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Begins to connect to the program's robot; both must stay. NULL, or if it must
 * not begin the reason, a line for a person: there is no driver for the robot, or
 * not the room that it wants (loop.c has FROB_DEVICE_MOST and FROB_INPUT_MOST), or
 * arithmetic here is not what the program is compiled for (<frob/arithmetic.h>). */
const char *loop_start(const struct frob_serial *serial, const struct frob_clock *clock);

/* The rate of the robot's line at first, bits per second; 0 without a driver. */
uint32_t loop_line_rate(void);

/* One round: what has arrived, what is due, perhaps a step. Gives when it
 * wants to be called next if no byte comes before. */
int64_t loop_round(void);

/* From a timer's interrupt, ten times a second or more often. */
void loop_watch(int64_t now_ns);

/* Tells the robot to stop, whatever the loop is doing: for faults. */
void loop_stop(void);

/* The program's input, for <frob/console.h>: what buttons and dials of the board do to the
 * operator's console counts at the next step. To be touched between rounds, not in an
 * interrupt. */
void *loop_input(void);

struct loop_counts {
    uint32_t steps, overruns, late, stale, connections;
};

struct loop_counts loop_count(void);

#ifdef __cplusplus
}
#endif
#endif
