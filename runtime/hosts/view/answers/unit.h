/* unit.h -- reads units of measure, and finds their scales and dimensions. */
#ifndef FROB_VIEW_UNIT_H
#define FROB_VIEW_UNIT_H

#include "../buffer.h"

#include <stdbool.h>
#include <stddef.h>

#define UNIT_FACTORS 10

/* A product of powers of base units, such as m^1 s^-2. */
struct dimension {
    bool is_open; /* whether it matches any dimension, because it is unknown or belongs to the
                   * number 0 */
    struct {
        char name[28];
        double power;
    } factors[UNIT_FACTORS];
    size_t count;
};

/* Reads a unit such as `cm/s^2`, and determines its dimension and its scale relative to the
 * base units (m, s, rad). If `takes_any` is true, a name that is not a unit in the library counts
 * as a base unit of the program. Returns false if there is no such unit. */
bool unit_read(const char *text, size_t length, bool takes_any, struct dimension *dimension,
               double *scale);

struct dimension dimension_product(const struct dimension *a, const struct dimension *b,
                                   double power_of_b);
bool dimensions_match(const struct dimension *a, const struct dimension *b);

/* Appends a dimension in the syntax of the language, or `a plain number` if it is dimensionless. */
void dimension_write(const struct dimension *dimension, struct buffer *text);

#endif
