/* streams.h -- standard input, output and error of a host. */
#ifndef FROB_HOST_STREAMS_H
#define FROB_HOST_STREAMS_H

#include <stdbool.h>

/* To be called before anything is opened. The numbers 0 to 2 are taken: where a
 * stream was closed by who started the process, the number would be that of what is
 * opened next, and messages would go to a robot. Reading and writing a stream that
 * was closed fails as before. And a file that is longer than is allowed makes writing
 * fail, as a full disk does, instead of ending the process. */
void streams_open(void);

/* Writes what is left of standard output. False, with a line on standard error, if
 * not all could be written. */
bool streams_flush(void);

#endif
