/* unit.h -- the scales of the library's units of measure. */
#ifndef FROB_VIEW_UNIT_H
#define FROB_VIEW_UNIT_H

#include <stdbool.h>
#include <stddef.h>

/* Computes the scale of a unit such as `cm/s^2`, relative to the base units (m, s, rad). Returns
 * false if there is no such unit. */
bool unit_read(const char *text, size_t length, double *scale);

#endif
