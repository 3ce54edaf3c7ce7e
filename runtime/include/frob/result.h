/* frob/result.h -- determines whether a program has ended, and what its result is.
 *
 * A program that is a task ends when the task ends. From that step on, the robot is at rest, and
 * the output contains the task's result. */
#ifndef FROB_RESULT_H
#define FROB_RESULT_H

#include <frob/program.h>
#include <frob/text.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Returns whether the program has ended, according to the output of its last step. Always false if
 * the program is not a task. */
bool frob_has_ended(const struct frob_program *program, const void *output);

/* Appends the result in Frob's syntax: `()`, `Just 2.5`. Appends nothing if the program has not
 * ended. */
void frob_result_write(struct frob_text *text, const struct frob_program *program,
                       const void *output);

/* Returns the size of a buffer that is large enough for any result, with the NUL. */
size_t frob_result_room(const struct frob_program *program);

#ifdef __cplusplus
}
#endif
#endif
