/* streams.h -- a host's standard input, output and error. */
#ifndef FROB_HOST_STREAMS_H
#define FROB_HOST_STREAMS_H

#include <stdbool.h>

/* Call this before opening anything. It makes sure that the descriptors 0 to 2 are in use. If the
 * parent process closed one of them, the next opened file would get its number, and messages could
 * go to a robot. Reading or writing a stream that was closed fails as before. In addition,
 * exceeding the maximum file size makes writing fail, like a full disk, instead of ending the
 * process. */
void streams_open(void);

/* Replaces control characters on standard error with decimal codes (an escape becomes \027), so
 * that file names, cells and labels cannot send escape sequences to a terminal. Does the same for
 * standard output if it is a terminal. streams_open calls this. */
void streams_keep_plain(void);

/* Does the same for standard output even if it is not a terminal. Use it for text output. */
void streams_plain_output(void);

/* Flushes standard output. If not everything could be written, prints a line on standard error and
 * returns false. */
bool streams_flush(void);

#endif
