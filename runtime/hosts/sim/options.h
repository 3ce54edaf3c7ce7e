/* options.h -- the command line of frob-sim. */
#ifndef FROB_HOST_SIM_OPTIONS_H
#define FROB_HOST_SIM_OPTIONS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct options {
    const char *program; /* PROGRAM.so */
    const char *world;
    double duration_s; /* may be without end */
    double rate_hz;    /* of the controller */
    uint64_t seed;
    double wall_distance_m; /* 0: as the world file says */
    bool realtime, strict, progress;
    bool console;            /* keys typed on standard input are the program's */
    bool exit_when_done;     /* end the run when the program has ended */
    bool stop_when_violated; /* and when an assertion of it is violated */
    const char *record;      /* CSV; NULL: none */
    const char *picture;     /* NULL: none */
    char *const *viewer;     /* a command, which ends with NULL; NULL: none */
    const char *judge;       /* JUDGE.so of a trial; NULL: an ordinary run */
    const char *runs;        /* of a trial, a file with runs instead of seeds; NULL: none */
    uint64_t last_seed;      /* of a trial, from `seed` on */
    const char **params;     /* values of the program's parameters, NAME=VALUE each */
    size_t param_count;
};

/* Reads the command line; `params` is memory to be freed. False if it is wrong, with a line on
 * standard error. */
bool read_options(int argc, char **argv, struct options *options);

/* The usage text. */
extern const char usage[];

#endif
