/* run.h -- the state of a run, which the files of the supervisor share. */
#ifndef FROB_HOST_ROBOT_RUN_H
#define FROB_HOST_ROBOT_RUN_H

#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "../camera/cameras.h"
#include "../common/claims.h"
#include "../common/console.h"
#include "../common/params.h"
#include "../common/publisher.h"
#include "../common/record.h"
#include "../common/touches.h"
#include "controller.h"
#include "core/robot.h"
#include "guard.h"
#include "instants.h"
#include "line.h"
#include "options.h"
#include <frob/program.h>

enum { DONE = 0, WRONG_USE = 2, FAULT = 4 };

struct run {
    const struct options *options;
    const struct frob_program *program;
    const struct params *all_params;
    const void *params; /* their values */
    const struct frob_driver *driver;
    int64_t patience_ns, period_ns;

    struct line line;
    struct frob_robot robot;
    void *device;
    struct guards guards;
    struct controller controller;
    struct record record;
    struct instants instants;
    struct claims claims;
    size_t failing;    /* number of assertions failing when verdicts were last published */
    int64_t judged_ns; /* time at which verdicts were last published */
    struct console console;
    struct touches touches;
    struct publisher publisher;
    struct cameras cameras;
    sigset_t waiting_mask; /* the signal mask that unblocks signals, used only while
                            * waiting */
    bool tells;

    void *input, *output;
    /* The program's time, which is based on the monotonic clock or on a simulator's clock
     * (line.h). */
    bool started;       /* whether the first instant has begun */
    int64_t first_ns;   /* the program's time in the first instant */
    int64_t instant_ns; /* time of the last instant, relative to the first one */
    int64_t due_ns;     /* the program's time at the next instant, if `scheduled` */
    bool scheduled;     /* if false, the next instant begins as soon as the robot is
                         * ready */
    int64_t asked_ns;   /* time at which the last step was requested */
    bool stepping;      /* whether a step was requested and has not been answered yet */
    bool late;          /* whether this step has taken longer than `--patience` */
    bool paused;        /* whether other programs have requested a pause */
    bool was_paused;    /* whether the next instant is the first one after a pause */
    uint32_t resets;    /* number of resets requested so far */
    int64_t lost_ns;    /* time at which the robot was lost; 0 if it is not lost */
    int64_t looped_ns;  /* start time of the last loop iteration; 0 before the first */
    int64_t awake_ns;   /* time at which this process last resumed after it was suspended */

    uint64_t steps, overruns, late_steps;
    int64_t longest_ns;
    bool record_ended; /* the recording contains no more instants */
    bool ended;        /* whether the program's task has ended */
    int64_t ended_ns;

    bool over;
    int status;
    char cause[512];
};

int64_t run_now_ns(void);

/* Returns the program's time, or INT64_MIN if it is not known yet. */
int64_t run_program_ns(const struct run *s, int64_t now);

bool run_follows_our_clock(const struct run *s, int64_t now);

/* Writes a line to standard error, unless the run is silent. */
void run_tell(const struct run *s, const char *format, ...);

/* Ends the run with this exit status. Only the first cause is reported. */
void run_end(struct run *s, int status, const char *format, ...);

#endif
