/* controller.h -- runs the program's step in a separate process, so that the supervisor continues
 * even if that process crashes, hangs, or is killed or stopped by a signal.
 *
 * One message requests a step, with dt and the input; the answer contains the output. */
#ifndef FROB_HOST_ROBOT_CONTROLLER_H
#define FROB_HOST_ROBOT_CONTROLLER_H

#include <stdbool.h>
#include <sys/types.h>

#include <frob/program.h>

#include "../common/params.h"
#include "options.h"

struct controller {
    pid_t pid; /* 0: none */
    int socket;
    size_t input_size, output_size;
    char *message; /* buffer for a request or an answer */
};

/* Starts the process, with the program reset. On failure prints a line on standard error and
 * returns false. */
bool controller_start(struct controller *c, const struct params *params,
                      const struct options *options);

/* Requests a step, dt_ns after the previous one. The process replaces the dt of its first step with
 * 0. Returns false if the process is gone. */
bool controller_ask(struct controller *c, int64_t dt_ns, const void *input);

/* Resets the program, which must not be running a step. Returns false if the process is gone. */
bool controller_reset(struct controller *c, const void *input);

enum controller_answer { CONTROLLER_BUSY, CONTROLLER_ANSWERED, CONTROLLER_GONE };

/* Takes the answer if it has arrived. Never waits. */
enum controller_answer controller_take(struct controller *c, void *output);

/* Ends the process, whatever it is doing. First waits up to `patience_ms` for it to end by itself.
 * Returns how it ended, such as "was killed by signal 9" or "ended with status 1"; NULL if there is
 * no process. */
const char *controller_end(struct controller *c, int patience_ms);

#endif
