/* compare.h -- compares the run with a second recording, in place of an edited program. If that
 * recording comes from a different version of the program, only its inputs and outputs are
 * known. */
#ifndef FROB_VIEW_COMPARE_H
#define FROB_VIEW_COMPARE_H

#include "what_if.h"

/* Reads a recording, and runs the program over it. Removes the previous edited program or
 * recording. On failure, prints a line on standard error and returns false. */
bool compare_start(struct what_if *other, const struct signals *recorded, const char *file,
                   const struct csv_dialect *dialect);

/* Finds the instant of the other recording that corresponds in time to instant `k` of this
 * one. Returns false if there is none. */
bool compare_instant(const struct what_if *other, const struct recording *recording, size_t k,
                     size_t *there);

/* Finds the first instant of this recording at which the outputs differ, and stores it in
 * `other`. */
void compare_find_difference(struct what_if *other, const struct recording *recording);

#endif
