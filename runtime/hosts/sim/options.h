/* options.h -- the command line of frob-sim. */
#ifndef FROB_HOST_SIM_OPTIONS_H
#define FROB_HOST_SIM_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct options {
    const char *program; /* PROGRAM.so */
    const char *world;
    double duration_s; /* may be infinite */
    double rate_hz;    /* rate of the controller */
    uint64_t seed;
    double wall_distance_m; /* 0: from the world file */
    bool realtime, strict, progress;
    bool console;            /* whether to pass keys typed on standard input to the program */
    bool exit_when_done;     /* whether to end the run when the program ends */
    bool stop_when_violated; /* whether to end the run when an assertion is violated */
    const char *record;      /* CSV; NULL: none */
    const char *picture;     /* NULL: none */
    char *const *viewer;     /* NULL-terminated command; NULL if there is none */
    const char *judge;       /* JUDGE.so for a trial; NULL for an ordinary run */
    const char *runs;        /* for a trial, a file that lists runs, to use instead of seeds;
                              * NULL if there is none */
    uint64_t last_seed;      /* for a trial, the last seed; the first one is `seed` */
    const char **params;     /* NAME=VALUE for each parameter that is set */
    size_t param_count;
};

/* Parses the command line; the caller frees `params`. If the command line is invalid, prints a line
 * on standard error and returns false. */
bool read_options(int argc, char **argv, struct options *options);

/* The usage text. */
extern const char usage[];

#endif
