/* frob/console.h -- the keys that are typed on a host's console, as events of a robot's
 * input: its field `key`. */
#ifndef FROB_CONSOLE_H
#define FROB_CONSOLE_H

#include <frob/program.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Sets the event of an instant: a key's character code, or -1 for none. Nothing
 * happens if the program's input has no such field. */
void frob_console_key(const struct frob_program *program, void *input, int32_t key);

#ifdef __cplusplus
}
#endif
#endif
