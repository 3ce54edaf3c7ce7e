/* options.h -- the command line of a program that drives a robot. */
#ifndef FROB_HOST_ROBOT_OPTIONS_H
#define FROB_HOST_ROBOT_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <frob/program.h>

#include "drivers/driver.h"
#include "hosts/camera/cameras.h"

enum { SETTINGS_MOST = 64 };

struct options {
    const char *device;
    double duration_s;  /* 0: until it is ended */
    double rate_hz;     /* of the controller */
    double patience_s;  /* with old readings and unfinished steps */
    double reconnect_s; /* for a lost robot to come back */
    const char *record; /* CSV; NULL: none */
    int priority;       /* real-time, 1 to 99; 0: none */
    bool lock_memory;
    bool console;            /* keys typed on standard input are the program's */
    bool exit_when_done;     /* when the program's task has ended */
    bool stop_when_violated; /* when an assertion of it is violated */
    char *const *viewer;     /* a command, which ends with NULL; NULL: none */
    bool control;            /* who looks on may send events */
    bool progress;           /* tell also where it is no terminal */
    const char **params;     /* values of the program's parameters, NAME=VALUE each */
    size_t param_count;
    double settings[SETTINGS_MOST];              /* of the driver, in its order */
    struct camera_options cameras[CAMERAS_MOST]; /* that the program looks through */
    size_t camera_count;
};

enum options_result { OPTIONS_RUN, OPTIONS_SHOWN, OPTIONS_WRONG };

/* Reads the command line of a program for the driver's robot; `params` is memory to be freed.
 * OPTIONS_SHOWN: help was asked for and given. OPTIONS_WRONG: a line on
 * standard error says what. */
enum options_result read_options(int argc, char **argv, const struct frob_program *program,
                                 const struct frob_driver *driver, struct options *options);

#endif
