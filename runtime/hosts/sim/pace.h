/* pace.h -- the speed of a simulated run: as fast as possible, in real time, or as set by a
 * viewer. A viewer can also pause the run and single-step it. */
#ifndef FROB_SIM_PACE_H
#define FROB_SIM_PACE_H

#include "../common/publisher.h"

#include <signal.h>

struct pace {
    struct publisher *publisher;
    const volatile sig_atomic_t *interrupted;
    bool is_free; /* whether to run as fast as possible if there is no viewer */
    bool was_paused;
    double speed;
    int64_t clock_ns, time_ns; /* one moment, as clock time and as time since the run started */
    int64_t last_ns;           /* time of the last instant */
    uint32_t steps;            /* number of steps taken while paused */
};

/* Starts pacing a run whose current time is 0. */
void pace_start(struct pace *pace, struct publisher *publisher,
                const volatile sig_atomic_t *interrupted, bool is_free);

/* Waits until the instant `time_ns` after the start of the run is due. Returns false if the run was
 * interrupted, or stopped by a viewer. */
bool pace_wait(struct pace *pace, int64_t time_ns);

#endif
