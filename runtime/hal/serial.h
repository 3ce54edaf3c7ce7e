/* hal/serial.h -- a serial line, as a port supplies it.
 *
 * A driver sees a line only through this table, so the same driver runs on a
 * terminal device, a TCP connection, a microcontroller's UART and bytes in
 * memory. How a line is opened and closed is the port's own business (what a
 * device is called differs); so is the memory of `port`.
 *
 * A line is raw: eight bits, no parity, one stop bit, no flow control, no
 * translation. One thread at a time may use it. A port that loses its device
 * says FROB_LOST at this and every later call. */
#ifndef FROB_HAL_SERIAL_H
#define FROB_HAL_SERIAL_H

#include <stddef.h>
#include <stdint.h>

#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

struct frob_serial_operations {
    /* Takes the bytes that have arrived, at most `room`; never waits. `*count`
     * is 0 when there are none, which is FROB_OK. */
    enum frob_status (*read)(void *port, uint8_t *bytes, size_t room, size_t *count);

    /* Hands over all bytes, waiting at most FROB_WRITE_PATIENCE_NS for room.
     * After FROB_TIMEOUT the line has some of them, or none. */
    enum frob_status (*write)(void *port, const uint8_t *bytes, size_t count);

    /* Waits until bytes can be read (FROB_OK) or the clock shows `until_ns`
     * (FROB_TIMEOUT), whichever is first; it may return early, with either. */
    enum frob_status (*wait)(void *port, int64_t until_ns);

    /* Changes the rate, in bits per second, after all that was written has
     * left. FROB_UNSUPPORTED, and nothing done, if the port cannot: the rate is
     * fixed, or somebody else's, as that of a bridge behind TCP. */
    enum frob_status (*set_rate)(void *port, uint32_t bits_per_s);

    /* Forgets what has arrived and was not read. */
    enum frob_status (*discard)(void *port);
};

/* How long a write may wait for room: less than any deadline of the host. */
#define FROB_WRITE_PATIENCE_NS INT64_C(20000000)

/* A line that is open: a port's functions and its memory. */
struct frob_serial {
    const struct frob_serial_operations *operations;
    void *port;
};

#ifdef __cplusplus
}
#endif
#endif
