/* trial.h -- runs a program and judges it with another program, which sees the true state of the
 * world: `trial` in the language, and the library's module Trial. */
#ifndef FROB_SIM_TRIAL_H
#define FROB_SIM_TRIAL_H

#include "controllers.h"
#include "options.h"

#include <stdio.h>

enum { TRIAL_TRUTHS = 8 };

struct trial {
    const struct frob_program *judge; /* a signal function from a Truth to a Verdict */
    const void *params;               /* the judge's parameters; initially its defaults */
    void *state, *input, *output;
    const struct frob_value *truths[TRIAL_TRUTHS]; /* input fields for the true state */
};

/* If memory runs out, prints a line on standard error and returns false. The caller must call
 * trial_close in this case, too. */
bool trial_open(struct trial *trial, const struct frob_program *judge);

/* Performs a run in an open simulation. The run ends at the first instant at which something
 * fails. Writes a line of tab-separated cells:
 *
 *   the seed;
 *   the verdict: `held`, `violated`, `undecided` (the judge was still waiting for something when
 *     time ran out), `unasked` (nothing had to hold at any instant) or `void` (an assumption
 *     failed);
 *   the time;
 *   the label of what failed, or `judge`;
 *   the first robot's x, y, heading and clearance at that time, whether something touches it, the
 *     distance that it has driven, and its odometry error;
 *   the number of its collisions, and for the first collision the time, x, y, clearance and object;
 *   `name=value` for each probe of the judge.
 *
 * Returns false if a recording or a picture cannot be written. */
bool trial_run(struct trial *trial, const struct options *options, const struct params *params,
               struct frob_sim *sim, FILE *file);

void trial_close(struct trial *trial);

#endif
