/* hal/posix/serial.h -- a serial line of a POSIX system: a terminal device, or
 * a TCP connection to a robot or a serial server.
 *
 * A terminal is made raw and locked: a second program that opens it this way
 * is told who holds it. A device is named by its path, best the one below
 * /dev/serial/by-id, which stays with the adapter; or `tcp:HOST:PORT`, or
 * `tcp:HOST` for the port 8101, the custom for robots. */
#ifndef FROB_HAL_POSIX_SERIAL_H
#define FROB_HAL_POSIX_SERIAL_H

#include <stdbool.h>

#include "hal/serial.h"

#ifdef __cplusplus
extern "C" {
#endif

struct frob_posix_line {
    int fd; /* -1: not open */
    bool is_terminal;
    bool lost;
    bool heard;              /* at least one byte came, since it was first opened */
    unsigned char peer[128]; /* of a TCP connection: its address, a struct sockaddr */
    unsigned peer_length;
};

/* Opens the device. On failure nothing is open, and `message` says what is
 * wrong and what helps, in one line; `room` is its size.
 * FROB_NOT_FOUND, FROB_DENIED, FROB_IN_USE, FROB_UNSUPPORTED (not a serial
 * line, or not that rate), FROB_TIMEOUT (TCP), FROB_LOST. */
enum frob_status frob_posix_open(struct frob_posix_line *line, const char *device,
                                 uint32_t bits_per_s, char *message, size_t room);

/* Opens a line again that was open, at `device`, which may be another path by
 * now. A robot on TCP is sought where it was: no name is looked up, and an
 * attempt takes half a second at the most. */
enum frob_status frob_posix_reopen(struct frob_posix_line *line, const char *device,
                                   uint32_t bits_per_s);

/* Lets what was written leave, for at most 0.2 s, and closes. */
void frob_posix_close(struct frob_posix_line *line);

struct frob_serial frob_posix_serial(struct frob_posix_line *line);

/* Whether the device is a TCP address and not a path. */
bool frob_posix_is_tcp(const char *device);

/* The path in `folder` (/dev/serial/by-id) that is a link to the same device
 * as `device`, which stays the same when the adapter is plugged in again.
 * False if there is none, or `device` is a link itself. */
bool frob_posix_lasting_name(const char *folder, const char *device, char *name, size_t room);

#ifdef __cplusplus
}
#endif
#endif
