/* claims.h -- collects the verdicts on a program's assertions in a run, and finds the first NaN in
 * each output column.
 *
 * If a program was compiled with its assertions (frob/program.h), its host passes each output to
 * claims_see, and reports at the end whether each assertion held. Once an assumption has failed,
 * verdicts on assertions no longer count. */
#ifndef FROB_HOST_CLAIMS_H
#define FROB_HOST_CLAIMS_H

#include <frob/program.h>

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

/* The constructors of the library's type Verdict, in the same order. VERDICT_NONE means that the
 * assertion has no verdict at an instant, because its signal function does not run. */
enum verdict { VERDICT_NONE = -1, VERDICT_NOT_ASKED, VERDICT_HOLDS, VERDICT_OPEN, VERDICT_FAILS };

/* Returns the worst verdict in a value. The value of an assertion in `mapSF` has a verdict for each
 * element. */
enum verdict verdict_of(const struct frob_value *value, const void *output);

struct claim_state {
    uint64_t asked;    /* number of instants at which the assertion had to hold */
    uint64_t failed;   /* number of instants at which the assertion failed */
    int64_t first_ns;  /* first instant at which the assertion failed */
    enum verdict last; /* the last verdict other than VERDICT_NONE */
    bool fails;        /* whether the assertion failed at the last instant */
};

/* A column of the output, and the time of its first NaN. */
struct nan_column {
    const struct frob_value *value;
    char *name;
    bool seen;        /* whether a NaN has occurred */
    int64_t first_ns; /* time of the first NaN */
};

struct claims {
    const struct frob_program *program;
    struct claim_state *each;
    bool is_void;                      /* whether an assumption has failed */
    int64_t void_ns;                   /* time at which the first assumption failed */
    const struct frob_claim *violated; /* the first violated assertion; NULL if there is none */
    int64_t violated_ns;
    struct nan_column *nans; /* every column of the output */
    size_t nan_count, nan_room;
    bool nan_is_given; /* whether the input contained a NaN; if so, NaNs in the output are no longer
                        * reported */
};

/* Returns whether a value contains a NaN. */
bool claims_has_nan(const struct frob_value *value, const void *base);

/* Returns false if memory runs out. */
bool claims_open(struct claims *claims, const struct frob_program *program);

/* Updates the verdicts and looks for NaNs in the output of an instant. */
void claims_see(struct claims *claims, int64_t time_ns, const void *output);

#define CLAIMS_FATE 100

/* Describes what happened to an assertion: `violated, first at 3.200 s; in total at 2 instants`. */
void claims_fate(const struct claims *claims, size_t i, char text[CLAIMS_FATE]);

/* Prints a line for each assertion, prefixed with `who`: `assert "keeps off": held`; and one for
 * each output column that contained a NaN: `NaN: out.turn, first at 3.200 s`. The first of these
 * also names the command that finds the cause. */
void claims_print(const struct claims *claims, FILE *file, const char *who);

/* Prints an error on standard error: `"keeps off" (wall.frob:12) was violated at 3.200 s`. */
void claims_complain(const struct claims *claims);

void claims_close(struct claims *claims);

#endif
