/* controller.h -- the program's step in a process of its own, so that whatever
 * it does (crash, hang, be killed or stopped) its supervisor goes on.
 *
 * One message asks for a step, with dt and the input; one answers, with the
 * output. */
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
    char *message; /* room for either */
};

/* Starts the process, in the state after reset. False with a line on standard
 * error. */
bool controller_start(struct controller *c, const struct params *params,
                      const struct options *options);

/* Asks for a step; false if the process is gone. */
bool controller_ask(struct controller *c, double dt, const void *input);

enum controller_answer { CONTROLLER_BUSY, CONTROLLER_ANSWERED, CONTROLLER_GONE };

/* Takes the answer, if it has come. Never waits. */
enum controller_answer controller_take(struct controller *c, void *output);

/* Ends the process, whatever it does, and says how it ended: "was ended by
 * signal 9", "ended with status 1"; NULL if there is none. `patience_ms` is how
 * long it may take to end by itself. */
const char *controller_end(struct controller *c, int patience_ms);

#endif
