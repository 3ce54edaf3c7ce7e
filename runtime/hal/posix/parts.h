/* parts.h -- shared by the files of the POSIX serial line. */
#ifndef FROB_HAL_POSIX_PARTS_H
#define FROB_HAL_POSIX_PARTS_H

#include "hal/posix/serial.h"

#include <sys/types.h>

/* rate_linux.c: sets any rate after all written bytes have been transmitted. Returns 0, or -1 and
 * sets errno. */
int frob_posix_set_terminal_rate(int fd, uint32_t bits_per_s);

/* rate_standard.c: does the same on any POSIX system, but only for the usual rates. */
int frob_posix_set_standard_rate(int fd, uint32_t bits_per_s);

/* holder_linux.c: writes the name of a program that has the device open, as `NAME (process N)`.
 * Returns false if it finds none, which may also be due to missing permissions. */
bool frob_posix_holder(const char *device, char *name, size_t room);

/* tcp.c: connects to `tcp:HOST:PORT`, waiting for at most 2 s for each address, and stores the
 * address in the line. */
enum frob_status frob_posix_connect(struct frob_posix_line *line, const char *device, char *message,
                                    size_t room);

/* tcp.c: connects to the address stored in the line, waiting for at most half a second. Returns 0
 * or an error number. */
int frob_posix_connect_again(struct frob_posix_line *line);

/* tcp.c: like write(), but a closed connection is an error and does not raise SIGPIPE. */
ssize_t frob_posix_send(int fd, const uint8_t *bytes, size_t count);

#endif
