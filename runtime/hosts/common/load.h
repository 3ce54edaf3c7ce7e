/* load.h -- finding the compiled program, as a shared object. */
#ifndef FROB_HOST_LOAD_H
#define FROB_HOST_LOAD_H

#include <frob/columns.h>
#include <frob/origins.h>
#include <frob/program.h>

/* Loads a program. NULL on failure, and if arithmetic in it or here is not what
 * programs are compiled for (<frob/arithmetic.h>), with one line on standard
 * error. The program stays loaded until the process ends. */
const struct frob_program *frob_load(const char *path);

/* Something else of the user's in the program that was loaded, such as the body of a
 * robot of their own: `frob_ROBOT_PART`. NULL if there is none. */
const void *frob_load_part(const char *robot, const char *part);

/* What is known of the columns of the program that was loaded; NULL if nothing. */
const struct frob_column *frob_load_columns(void);

/* Where the values of its columns come from; likewise. */
const struct frob_origin *frob_load_origins(void);

#endif
