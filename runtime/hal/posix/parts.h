/* parts.h -- what the files of the POSIX line share. */
#ifndef FROB_HAL_POSIX_PARTS_H
#define FROB_HAL_POSIX_PARTS_H

#include "hal/posix/serial.h"

#include <sys/types.h>

/* rate_linux.c: any rate; returns 0, or -1 with errno. Waits until what was
 * written has left. */
int frob_posix_set_terminal_rate(int fd, uint32_t bits_per_s);

/* rate_standard.c: the same, for the usual rates only, on any system. */
int frob_posix_set_standard_rate(int fd, uint32_t bits_per_s);

/* holder_linux.c: a program that has the device open, as `NAME (process N)`.
 * False if none is found, which may also be for want of rights. */
bool frob_posix_holder(const char *device, char *name, size_t room);

/* tcp.c: connects to `tcp:HOST:PORT`, for at most 2 s an address, and keeps the
 * address in the line. */
enum frob_status frob_posix_connect(struct frob_posix_line *line, const char *device, char *message,
                                    size_t room);

/* tcp.c: connects to the address that the line keeps, for at most half a second;
 * returns 0 or an error number. */
int frob_posix_connect_again(struct frob_posix_line *line);

/* As write; a connection that is gone is an error and no signal. */
ssize_t frob_posix_send(int fd, const uint8_t *bytes, size_t count);

#endif
