/* pace.h -- how fast a simulated run goes: as fast as it can, as a clock on the wall, or as
 * somebody who looks on wants it, who may also hold it and let it take single instants. */
#ifndef FROB_SIM_PACE_H
#define FROB_SIM_PACE_H

#include "../common/publisher.h"

#include <signal.h>

struct pace {
    struct publisher *publisher;
    const volatile sig_atomic_t *interrupted;
    bool is_free; /* as fast as it can, if nobody looks on */
    bool was_paused;
    double speed;
    int64_t clock_ns, time_ns; /* at which time on the clock the run was at which time */
    int64_t last_ns;           /* the last instant */
    uint32_t steps;            /* that were taken while paused */
};

/* From now on, at the run's time 0. */
void pace_start(struct pace *pace, struct publisher *publisher,
                const volatile sig_atomic_t *interrupted, bool is_free);

/* Waits until the instant at this time of the run is due. False if there will be none: the run
 * was interrupted, or stopped by who looks on. */
bool pace_wait(struct pace *pace, int64_t time_ns);

#endif
