/* frob/result.h -- whether a program has ended, and with what.
 *
 * The program of a task ends when the task does. From that step on the robot
 * rests, and the output holds what the task has ended with. */
#ifndef FROB_RESULT_H
#define FROB_RESULT_H

#include <frob/program.h>
#include <frob/text.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Has it ended, by what its last step put out? Never for a program that is
 * not of a task. */
bool frob_has_ended(const struct frob_program *program, const void *output);

/* Appends what it has ended with, as Frob would write it: `()`, `Just 2.5`.
 * Nothing if it has not ended. */
void frob_result_write(struct frob_text *text, const struct frob_program *program,
                       const void *output);

/* Room that is enough for a result, with the NUL. */
size_t frob_result_room(const struct frob_program *program);

#ifdef __cplusplus
}
#endif
#endif
