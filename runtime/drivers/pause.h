/* drivers/pause.h -- a pause in what arrives: what began before it is no packet.
 *
 * No robot pauses within a packet, but a line may be unplugged in the middle of
 * one, or a robot be turned off; then the packet's rest must not be made of what
 * is sent by the next one. */
#ifndef FROB_DRIVERS_PAUSE_H
#define FROB_DRIVERS_PAUSE_H

#include <stdbool.h>
#include <stdint.h>

#include "hal/clock.h"

/* Longer than from one byte of a packet to the next. */
#define FROB_PAUSE_NS INT64_C(100000000)

/* To be called when bytes have arrived: whether they come after a pause. `*heard_ns`
 * is when bytes arrived last, and is now afterwards. */
static inline bool frob_after_pause(const struct frob_clock *clock, int64_t *heard_ns)
{
    int64_t before_ns = *heard_ns;
    *heard_ns = frob_now_ns(clock);
    return *heard_ns - before_ns > FROB_PAUSE_NS;
}

#endif
