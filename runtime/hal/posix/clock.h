/* hal/posix/clock.h -- a clock that reads CLOCK_MONOTONIC. */
#ifndef FROB_HAL_POSIX_CLOCK_H
#define FROB_HAL_POSIX_CLOCK_H

#include "hal/clock.h"

/* The sleep ends early if a signal arrives. */
extern const struct frob_clock frob_posix_clock;

#endif
