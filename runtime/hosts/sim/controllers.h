/* controllers.h -- runs an instance of the program for each robot in the simulation.
 *
 * The robots share only the code: each has its own state, input, output and recording. */
#ifndef FROB_SIM_CONTROLLERS_H
#define FROB_SIM_CONTROLLERS_H

#include "../common/claims.h"
#include "../common/params.h"
#include "../common/record.h"
#include "../common/tag_finder.h"
#include "../common/touches.h"
#include "devices.h"

#include <frob/program.h>
#include <sim.h>

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct controller {
    void *state;
    void *input;
    void *output;
    struct record record;
    struct claims claims;
    char *record_name; /* NULL: no recording */
    bool ended;        /* whether the program's task has ended */
    int64_t ended_ns;  /* when it ended */
    void *result;      /* the output when the task ended */
};

struct controllers {
    const struct frob_program *program;
    const void *params; /* shared by all robots */
    struct frob_sim *sim;
    /* For each control on the console that uses a camera: the camera's number in the world. */
    int *cameras;
    const struct frob_image **frames; /* each camera's new frame at this instant; NULL if it has
                                       * none */
    struct tag_finder finder;         /* the tag finder, if the program uses tags */
    struct devices devices;           /* lidars and inertial measurement units */
    bool has_stepped;                 /* false before the first instant */
    int64_t stepped_ns;               /* time of the last instant */
    bool is_away;                     /* whether the world is in an outage, during which there are
                                       * no instants */
    bool rests;                       /* whether to replace the next command with zero, as after an
                                       * outage */
    void *rest;                       /* an output that is all zero */
    size_t count;
    size_t running; /* number of controllers whose program has not ended */
    struct controller *each;
};

/* Creates a controller for each robot, running the program with these parameters, which must stay
 * valid. `record` is the file name of the recording for a single robot. If there are several
 * robots, robot k (from 1) records to NAME-k.csv instead of NAME.csv. NULL means that there is no
 * recording. Prints a line on standard error and returns false if memory runs out, if a file cannot
 * be written, if the world lacks a camera or another device that the program uses, or if the tag
 * finder is not installed. The caller must call controllers_close in this case, too. */
bool controllers_open(struct controllers *c, const struct params *params, struct frob_sim *sim,
                      const char *record);

/* Runs one instant of all controllers: each reads its sensors, runs a step and sends its commands.
 * During an outage of the world, no steps run, nothing is recorded, and the robots are commanded to
 * stop. The first command after an outage is also a stop. `touches` apply to all robots. Returns
 * false if a recording cannot be written, or if memory runs out. */
bool controllers_step(struct controllers *c, int64_t now_ns, const struct touches *touches);

/* Returns the claims of the first robot whose program has violated an assertion; NULL if there is
 * none. */
const struct claims *controllers_violated(const struct controllers *c);

/* Returns false if a recording cannot be closed. */
bool controllers_close(struct controllers *c);

#endif
