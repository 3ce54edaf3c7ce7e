/* streams.h -- a host's standard input, output and error. */
#ifndef FROB_HOST_STREAMS_H
#define FROB_HOST_STREAMS_H

#include <stdbool.h>

/* Makes sure that the descriptors 0 to 2 are in use. Must be called before anything is opened. If
 * the parent process has closed one of these descriptors, the next file that is opened would get
 * its number, and messages could be sent to a robot. Reading or writing the closed stream still
 * fails. In addition, if a file reaches the maximum size, writing fails, as on a full disk, instead
 * of ending the process. */
void streams_open(void);

/* Replaces control characters on standard error with decimal codes (an escape becomes \027), so
 * that file names, cells and labels cannot send escape sequences to a terminal. Does the same for
 * standard output if it is a terminal. streams_open calls this. */
void streams_keep_plain(void);

/* Replaces control characters on standard output even if it is not a terminal. Use it for text
 * output. */
void streams_plain_output(void);

/* Flushes standard output. If not everything could be written, prints a line on standard error and
 * returns false. */
bool streams_flush(void);

#endif
