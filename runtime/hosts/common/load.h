/* load.h -- loads a compiled program, which is a shared object. */
#ifndef FROB_HOST_LOAD_H
#define FROB_HOST_LOAD_H

#include <frob/columns.h>
#include <frob/origins.h>
#include <frob/program.h>

/* Loads a program, which stays loaded until the process ends. Returns NULL and prints a line on
 * standard error if loading fails, or if the floating-point arithmetic of the program or of this
 * host does not meet the requirements in <frob/arithmetic.h>. */
const struct frob_program *frob_load(const char *path);

/* Returns another symbol of the loaded program, such as the body of a user-defined robot:
 * `frob_ROBOT_PART`. NULL if there is none. */
const void *frob_load_part(const char *robot, const char *part);

/* Returns the descriptions of the loaded program's columns; NULL if it has none. */
const struct frob_column *frob_load_columns(void);

/* Returns the origins of the values in the loaded program's columns; NULL if it has none. */
const struct frob_origin *frob_load_origins(void);

#endif
