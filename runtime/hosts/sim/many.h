/* many.h -- many runs of a trial, each with a seed and parameters of its own: for `frobc sweep`. */
#ifndef FROB_SIM_MANY_H
#define FROB_SIM_MANY_H

#include "options.h"
#include "trial.h"

/* Opens the world for a run; NULL with a line on standard error. */
typedef struct frob_sim *many_open_world(const struct options *options,
                                         const struct frob_program *program);

/* The runs of the file `options->runs`, one a line, with tabs between its cells: a key, which is
 * any text; the seed; and each parameter that is set, `name=value`. The judge's parameters of the
 * same names are set too.
 *
 * Writes a line for each to standard output, as soon as it is done: the key, what trial_run
 * writes, and behind one more tab a checksum of all before it, FNV-1a of 64 bits, in hexadecimal.
 * So whoever reads knows which lines are whole. False when a run cannot be made, or a line cannot
 * be written, with a line on standard error; the lines before it stay. When the process that
 * started this one has ended, the run that is being made is the last. */
bool many_runs(struct trial *trial, const struct options *options,
               const struct frob_program *program, many_open_world *open_world);

#endif
