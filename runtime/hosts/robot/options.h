/* options.h -- the command line of a program that drives a robot. */
#ifndef FROB_HOST_ROBOT_OPTIONS_H
#define FROB_HOST_ROBOT_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <frob/program.h>

#include "drivers/driver.h"
#include "line.h"
#include "hosts/camera/cameras.h"

enum { SETTINGS_MOST = 64 };

struct options {
    const char *device;                 /* serial line; NULL if `opening` is used */
    const struct line_opening *opening; /* another kind of line; NULL for a serial line */
    const char *const *arguments;       /* arguments for `opening` */
    size_t argument_count;
    double duration_s;  /* 0: until interrupted */
    double rate_hz;     /* rate of the controller */
    double patience_s;  /* maximum age of a reading, and maximum duration of a step */
    double reconnect_s; /* maximum time to wait for a lost robot */
    const char *record; /* CSV file; NULL: none */
    int priority;       /* real-time priority, 1 to 99; 0 for none */
    bool lock_memory;
    bool console;            /* whether to pass keys typed on standard input to the program */
    bool exit_when_done;     /* whether to end the run when the program's task has ended */
    bool stop_when_violated; /* whether to end the run when an assertion is violated */
    char *const *viewer;     /* NULL-terminated command; NULL if there is none */
    bool control;            /* whether viewers may send events */
    bool progress;           /* whether to report progress even if standard error is not a
                              * terminal */
    const char **params;     /* NAME=VALUE for each parameter that is set */
    size_t param_count;
    double settings[SETTINGS_MOST];              /* the driver's settings, in the order of its
                                                    table */
    struct camera_options cameras[CAMERAS_MOST]; /* the cameras that the program uses */
    size_t camera_count;
};

enum options_result { OPTIONS_RUN, OPTIONS_SHOWN, OPTIONS_WRONG };

/* Reads the command line of a program for the driver's robot. The caller frees `params`. `opening`
 * describes how to open the connection to the robot; NULL for a serial port. Returns OPTIONS_SHOWN
 * after printing the help, and OPTIONS_WRONG after printing a mistake on standard error. */
enum options_result read_options(int argc, char **argv, const struct frob_program *program,
                                 const struct frob_driver *driver,
                                 const struct line_opening *opening, struct options *options);

#endif
