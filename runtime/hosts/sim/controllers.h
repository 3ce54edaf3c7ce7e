/* controllers.h -- the program, once for each robot of the simulation.
 *
 * The robots share the code and nothing else: each has a state of its own, its
 * own input and output, and its own record. */
#ifndef FROB_SIM_CONTROLLERS_H
#define FROB_SIM_CONTROLLERS_H

#include "../common/claims.h"
#include "../common/params.h"
#include "../common/record.h"
#include "../common/tag_finder.h"
#include "../common/touches.h"

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
    char *record_name; /* NULL: nothing is recorded */
    bool ended;        /* the program's task has, … */
    int64_t ended_ns;  /* … at this time, … */
    void *result;      /* … with this output */
};

struct controllers {
    const struct frob_program *program;
    const void *params; /* the same for all */
    struct frob_sim *sim;
    int *cameras; /* of each thing on the console that is one's, its number in the world */
    const struct frob_image **frames; /* of each of these, at the instant; else NULL */
    struct tag_finder finder;         /* if tags are asked for */
    size_t count;
    size_t running; /* those that have not ended */
    struct controller *each;
};

/* Makes a controller for each robot, of the program of these parameters, which must stay. `record` is the file for the rows of the
 * only robot; of several, robot k has NAME-k.csv for NAME.csv, from 1. NULL:
 * nothing is recorded. False when there is not enough memory, when a file cannot
 * be written, when the world lacks a camera that the program asks for, or what finds tags is not
 * there, with a line on standard error; close it then, too. */
bool controllers_open(struct controllers *c, const struct params *params, struct frob_sim *sim,
                      const char *record);

/* An instant of all of them, `dt_s` after the one before: each reads its sensors,
 * steps and commands. The touches are for all. False when a record cannot be written, or
 * there is not enough memory. */
bool controllers_step(struct controllers *c, int64_t now_ns, double dt_s,
                      const struct touches *touches);

/* Of the first robot whose program has violated an assertion; NULL if none has. */
const struct claims *controllers_violated(const struct controllers *c);

/* False when a record cannot be closed. */
bool controllers_close(struct controllers *c);

#endif
