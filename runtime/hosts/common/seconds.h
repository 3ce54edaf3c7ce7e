/* seconds.h -- the time of an instant, as a trace writes it. */
#ifndef FROB_HOST_SECONDS_H
#define FROB_HOST_SECONDS_H

#include <stdbool.h>
#include <stdint.h>

/* Seconds as whole nanoseconds, exactly, rounded half away from zero; in
 * decimal arithmetic, for a double has too few digits for a year of them. False
 * if the text is no number of seconds, or beyond 10^9 of them. */
bool seconds_read(const char *text, int64_t *result);

#endif
