/* drivers/pause.h -- detects pauses in received bytes. A packet that began before a pause is
 * incomplete.
 *
 * Robots do not pause within a packet, but the line may be unplugged or the robot turned off in
 * the middle of one. The bytes that the robot sends next must not be read as the rest of that
 * packet. */
#ifndef FROB_DRIVERS_PAUSE_H
#define FROB_DRIVERS_PAUSE_H

#include <stdbool.h>
#include <stdint.h>

#include "hal/clock.h"

/* Longer than the time between two bytes of a packet. */
#define FROB_PAUSE_NS INT64_C(100000000)

/* Returns whether bytes that have just arrived follow a pause. `*heard_ns` must be the time of
 * the previous bytes; the function sets it to the current time. */
static inline bool frob_after_pause(const struct frob_clock *clock, int64_t *heard_ns)
{
    int64_t before_ns = *heard_ns;
    *heard_ns = frob_now_ns(clock);
    return *heard_ns - before_ns > FROB_PAUSE_NS;
}

#endif
