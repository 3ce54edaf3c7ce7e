/* hal/posix/serial.h -- a serial line on a POSIX system: a terminal device, or a TCP connection to
 * a robot or a serial server.
 *
 * A terminal is set to raw mode and locked. A second program that opens it with this module gets a
 * message that names the first one. A device is given as its path (preferably one in
 * /dev/serial/by-id, which persists when the adapter is plugged in again), as `tcp:HOST:PORT`, or
 * as `tcp:HOST` for port 8101, the usual port for robots. */
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
    bool heard;              /* whether a byte has been received since the line was first opened */
    unsigned char peer[128]; /* address of a TCP connection, as a struct sockaddr */
    unsigned peer_length;
};

/* Opens the device. On failure, nothing is open, and `message`, whose size is `room`, contains a
 * line that explains the problem and how to fix it. Returns FROB_OK, FROB_NOT_FOUND, FROB_DENIED,
 * FROB_IN_USE, FROB_UNSUPPORTED (not a serial line, or not that rate), FROB_TIMEOUT (TCP) or
 * FROB_LOST. */
enum frob_status frob_posix_open(struct frob_posix_line *line, const char *device,
                                 uint32_t bits_per_s, char *message, size_t room);

/* Uses an open socket as the line. */
void frob_posix_adopt(struct frob_posix_line *line, int socket);

/* Reopens a line that was open. The path of its device may have changed to `device`. For TCP,
 * connects to the previous address without looking up the name, and waits for at most half a
 * second. */
enum frob_status frob_posix_reopen(struct frob_posix_line *line, const char *device,
                                   uint32_t bits_per_s);

/* Waits for at most 0.2 s until the written bytes have been transmitted, and closes the line. */
void frob_posix_close(struct frob_posix_line *line);

struct frob_serial frob_posix_serial(struct frob_posix_line *line);

/* Returns whether the device is a TCP address rather than a path. */
bool frob_posix_is_tcp(const char *device);

/* Finds the path in `folder` (/dev/serial/by-id) that links to the same device as `device` and
 * persists when the adapter is plugged in again. Returns false if there is none, or if `device` is
 * a link itself. */
bool frob_posix_lasting_name(const char *folder, const char *device, char *name, size_t room);

#ifdef __cplusplus
}
#endif
#endif
