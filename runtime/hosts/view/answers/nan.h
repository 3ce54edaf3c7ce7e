/* nan.h -- finds the origin of NaN in a program's output. */
#ifndef FROB_VIEW_NAN_H
#define FROB_VIEW_NAN_H

#include "view.h"

/* Runs the program over the whole recording. Prints a line for each column of its output that is
 * NaN at some instant, and for each assertion that was violated because of a NaN:
 *
 *   NaN: out.forward, first at 2.000 s, from integral.x at wall.frob:7
 *
 * The origin is an input, or the first signal that is NaN although none of its operands is. If the
 * program cannot run on the recording, prints an error and returns false. */
bool nan_print(struct view *view);

#endif
