/* hal/cortex_m/board.h -- a board with a Cortex-M: here ARM's MPS2 with the
 * image AN386 (a Cortex-M4), which qemu emulates as `mps2-an386`.
 *
 * Another board with a Cortex-M keeps startup.c and clock.c, whose registers
 * are the processor's own, and replaces the constants below, serial.c and the
 * linker script. The robot is on UART 0, what is said to a person on UART 1.
 *
 * Sources: ARMv7-M Architecture Reference Manual (DDI 0403E), B3.2 and B3.3;
 * Cortex-M System Design Kit manual (DDI 0479D), 4.3, "APB UART"; application
 * note AN386, memory map and interrupts. */
#ifndef FROB_HAL_CORTEX_M_BOARD_H
#define FROB_HAL_CORTEX_M_BOARD_H

#include <stddef.h>
#include <stdint.h>

#include "hal/clock.h"
#include "hal/serial.h"

/* Of the processor, and of the UARTs' dividers. */
#define BOARD_CLOCK_HZ 25000000u

/* Starts the timer; `tick` is called from its interrupt, a thousand times a
 * second. Call it once, before anything else. */
void board_clock_start(void (*tick)(int64_t now_ns));

extern const struct frob_clock board_clock;

/* Sets UART 0 up. Bytes are received by interrupt; one that finds the ring
 * full is dropped. */
void board_serial_open(uint32_t bits_per_s);

extern const struct frob_serial board_serial;

/* Writes text on UART 1. */
void board_say(const char *text);

/* How much of the stack has been used since the start, and of how much. */
size_t board_stack_used(void);
size_t board_stack_size(void);

/* The interrupts, for the table in startup.c. */
void board_on_tick(void);
void board_on_receive(void);

/* What a fault of the processor ends in; main.c stops the robot here. */
void board_on_fault(void);

#endif
