/* hal/serial.h -- the serial line that a port supplies.
 *
 * A driver accesses a line only through this table, so the same driver works with a terminal
 * device, a TCP connection, a microcontroller's UART or bytes in memory. Each port opens and closes
 * lines in its own way (devices are named differently), and owns the memory of `port`.
 *
 * A line is raw: eight bits, no parity, one stop bit, no flow control, no translation. Only one
 * thread at a time may use it. After a port has lost its device, all calls return FROB_LOST. */
#ifndef FROB_HAL_SERIAL_H
#define FROB_HAL_SERIAL_H

#include <stddef.h>
#include <stdint.h>

#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

struct frob_serial_operations {
    /* Reads the bytes that have arrived, at most `room`, without waiting. If there are none,
     * `*count` is 0 and the result is FROB_OK. */
    enum frob_status (*read)(void *port, uint8_t *bytes, size_t room, size_t *count);

    /* Writes all bytes, waiting at most FROB_WRITE_PATIENCE_NS for room. After FROB_TIMEOUT the
     * line may have accepted some of them. */
    enum frob_status (*write)(void *port, const uint8_t *bytes, size_t count);

    /* Waits until bytes can be read (FROB_OK) or the clock shows `until_ns` (FROB_TIMEOUT),
     * whichever comes first. It may return early, with either result. */
    enum frob_status (*wait)(void *port, int64_t until_ns);

    /* Changes the bit rate after all written bytes have been transmitted. Returns FROB_UNSUPPORTED
     * and does nothing if the port cannot change the rate, because it is fixed or because another
     * device, such as a TCP bridge, sets it. */
    enum frob_status (*set_rate)(void *port, uint32_t bits_per_s);

    /* Discards the bytes that have arrived but have not been read. */
    enum frob_status (*discard)(void *port);
};

/* Maximum time for which a write waits for space. It is shorter than any deadline of the host. */
#define FROB_WRITE_PATIENCE_NS INT64_C(20000000)

/* An open line: a port's functions and its memory. */
struct frob_serial {
    const struct frob_serial_operations *operations;
    void *port;
};

#ifdef __cplusplus
}
#endif
#endif
