#include "realtime.h"

#include <errno.h>
#include <sched.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>

void realtime_apply(const struct options *options, enum realtime_process process)
{
    bool tells = process == REALTIME_SUPERVISOR;
    if (options->priority > 0) {
        struct sched_param parameters;
        memset(&parameters, 0, sizeof parameters);
        /* The supervisor must be able to interrupt a controller that hangs. */
        parameters.sched_priority = options->priority;
        if (process == REALTIME_CONTROLLER && parameters.sched_priority > 1)
            parameters.sched_priority--;
        if (sched_setscheduler(0, SCHED_FIFO, &parameters) != 0 && tells)
            fprintf(
                stderr,
                "warning: cannot set real-time priority %d: %s; the run continues without it. Run "
                "the program as root, or add a line `YOU - rtprio %d` to "
                "/etc/security/limits.conf\n",
                options->priority, strerror(errno), options->priority);
    }
    if (options->lock_memory && mlockall(MCL_CURRENT | MCL_FUTURE) != 0 && tells)
        fprintf(stderr,
                "warning: cannot lock memory: %s; the run continues with unlocked memory. Run the "
                "program as root, or add a line `YOU - memlock unlimited` to "
                "/etc/security/limits.conf\n",
                strerror(errno));
}
