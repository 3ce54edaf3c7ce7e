/* many.h -- many runs of a trial, each with its own seed and parameters, for `frobc sweep`. */
#ifndef FROB_SIM_MANY_H
#define FROB_SIM_MANY_H

#include "options.h"
#include "trial.h"

/* Opens the world for a run. On failure, returns NULL and prints a line on standard error. */
typedef struct frob_sim *many_open_world(const struct options *options,
                                         const struct frob_program *program);

/* Performs the runs listed in the file `options->runs`, one per line, with tab-separated cells: a
 * key, which may be any text; the seed; and a `name=value` for each parameter to set. Parameters of
 * the judge with the same names are also set.
 *
 * After each run, writes a line to standard output: the key, the output of trial_run, and a
 * checksum of everything before it (64-bit FNV-1a, in hexadecimal), so that readers can detect
 * incomplete lines. If a run cannot be started or a line cannot be written, prints a line on
 * standard error and returns false; the lines before it remain valid. If the parent process ends,
 * the current run is the last one. */
bool many_runs(struct trial *trial, const struct options *options,
               const struct frob_program *program, many_open_world *open_world);

#endif
