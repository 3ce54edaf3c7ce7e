/* seconds.h -- reads the time of an instant in a trace. */
#ifndef FROB_HOST_SECONDS_H
#define FROB_HOST_SECONDS_H

#include <stdbool.h>
#include <stdint.h>

/* Maximum time; times since 1970 reach it in the year 2096. */
#define MOST_SECONDS INT64_C(4000000000)

/* Converts seconds to whole nanoseconds, correctly rounded (half away from zero). Uses decimal
 * arithmetic, because a double cannot represent a year in nanoseconds exactly. Returns false if the
 * text is not a number of seconds, or exceeds MOST_SECONDS. */
bool seconds_read(const char *text, int64_t *result);

/* If `text` was rejected because it exceeds MOST_SECONDS, returns a hint for the error message,
 * otherwise an empty string. */
const char *seconds_too_far(const char *text);

#endif
