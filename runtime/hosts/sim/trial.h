/* trial.h -- runs of a program that are judged by another program, which sees what really
 * happens: `trial` in the language, and the library's module Trial. */
#ifndef FROB_SIM_TRIAL_H
#define FROB_SIM_TRIAL_H

#include "controllers.h"
#include "options.h"

#include <stdio.h>

enum { TRIAL_TRUTHS = 8 };

struct trial {
    const struct frob_program *judge; /* from a Truth to a Verdict */
    const void *params;               /* the judge's; its default */
    void *state, *input, *output;
    const struct frob_value *truths[TRIAL_TRUTHS]; /* where what is true goes in the input */
};

/* False without memory, with a line on standard error; close it then, too. */
bool trial_open(struct trial *trial, const struct frob_program *judge);

/* A run in an opened simulation, which ends at the first instant at which something fails.
 * Writes a line with tabs between its cells: the seed; `held`, `violated`, `undecided` (the judge
 * waits for something when the time is over), `unasked` (nothing was to hold at any instant) or
 * `void` (an assumption failed); at what time; the label of what failed, or `judge`; and of the
 * first robot at that time x, y, heading, clearance, whether something touches it, the way
 * driven and the error of its odometry; and then each probe of the judge, `name=value`. False
 * when a record or a picture cannot be written. */
bool trial_run(struct trial *trial, const struct options *options, const struct params *params,
               struct frob_sim *sim, FILE *file);

void trial_close(struct trial *trial);

#endif
