/* hal/template/template.h -- a port to copy: it compiles but does nothing.
 *
 * For a new board, copy this folder, and replace each function with code for the board.
 * docs/porting.md explains each function, and the order in which to test them. A board with one
 * robot needs only one line and one clock, so the memory of both is static here. */
#ifndef FROB_HAL_TEMPLATE_H
#define FROB_HAL_TEMPLATE_H

#include "hal/clock.h"
#include "hal/serial.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Sets up the timer. Call it once, before anything else. */
void frob_template_clock_start(void);

/* Sets up the UART: 8N1, no flow control, receiving by interrupt. */
enum frob_status frob_template_serial_open(uint32_t bits_per_s);

extern const struct frob_clock frob_template_clock;
extern const struct frob_serial frob_template_serial;

/* Writes a human-readable line: to a second UART, to a display, or nowhere. */
void frob_template_say(const char *text);

#ifdef __cplusplus
}
#endif
#endif
