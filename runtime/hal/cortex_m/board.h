/* hal/cortex_m/board.h -- a Cortex-M board: ARM's MPS2 with the image AN386 (a Cortex-M4), which
 * qemu emulates as `mps2-an386`.
 *
 * For another Cortex-M board, keep startup.c and clock.c, which use only the processor's own
 * registers, and replace the constants below, serial.c and the linker script. The robot is
 * connected to UART 0; human-readable messages are written to UART 1.
 *
 * Sources: ARMv7-M Architecture Reference Manual (DDI 0403E), B3.2 and B3.3; Cortex-M System Design
 * Kit manual (DDI 0479D), 4.3, "APB UART"; application note AN386, memory map and interrupts. */
#ifndef FROB_HAL_CORTEX_M_BOARD_H
#define FROB_HAL_CORTEX_M_BOARD_H

#include <stddef.h>
#include <stdint.h>

#include "hal/clock.h"
#include "hal/serial.h"

/* Clock frequency of the processor and of the UARTs' dividers. */
#define BOARD_CLOCK_HZ 25000000u

/* Starts the timer, whose interrupt calls `tick` a thousand times a second. Call it once, before
 * anything else. */
void board_clock_start(void (*tick)(int64_t now_ns));

extern const struct frob_clock board_clock;

/* Sets up UART 0. An interrupt handler stores received bytes in a ring buffer, and drops them if it
 * is full. */
void board_serial_open(uint32_t bits_per_s);

extern const struct frob_serial board_serial;

/* Writes text on UART 1. */
void board_say(const char *text);

/* The number of stack bytes that have been used since the start, and the size of the stack. */
size_t board_stack_used(void);
size_t board_stack_size(void);

/* Interrupt handlers, for the table in startup.c. */
void board_on_tick(void);
void board_on_receive(void);

/* Called when the processor detects a fault; main.c stops the robot in this function. */
void board_on_fault(void);

#endif
