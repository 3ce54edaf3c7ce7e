/* unit.h -- how large a unit of measure is, as the library has it. */
#ifndef FROB_VIEW_UNIT_H
#define FROB_VIEW_UNIT_H

#include <stdbool.h>
#include <stddef.h>

/* The scale of a unit such as `cm/s^2`, in units of scale 1 (m, s, rad). False if there is
 * no such unit. */
bool unit_read(const char *text, size_t length, double *scale);

#endif
