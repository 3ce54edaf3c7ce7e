/* claims.h -- what became of a program's assertions in a run.
 *
 * A host that was given a program with its assertions (frob/program.h) shows each output to
 * this, and tells at the end of each whether it held. An assumption that has failed voids what
 * is said of assertions from that instant on. */
#ifndef FROB_HOST_CLAIMS_H
#define FROB_HOST_CLAIMS_H

#include <frob/program.h>

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

/* As the library's Verdict, in its order; of an assertion that is not judged at an instant,
 * since its signal function does not run, there is none. */
enum verdict { VERDICT_NONE = -1, VERDICT_NOT_ASKED, VERDICT_HOLDS, VERDICT_OPEN, VERDICT_FAILS };

/* The worst verdict in a value: an assertion in `mapSF` has many. */
enum verdict verdict_of(const struct frob_value *value, const void *output);

struct claim_state {
    uint64_t asked;    /* instants at which it mattered */
    uint64_t failed;   /* instants at which it failed */
    int64_t first_ns;  /* the first of them */
    enum verdict last; /* the last that there was */
    bool fails;        /* at the instant that was seen last */
};

struct claims {
    const struct frob_program *program;
    struct claim_state *each;
    bool is_void;                      /* an assumption has failed, … */
    int64_t void_ns;                   /* … at this time */
    const struct frob_claim *violated; /* the first assertion that was, or NULL */
    int64_t violated_ns;
};

/* False without memory. */
bool claims_open(struct claims *claims, const struct frob_program *program);

/* The output of an instant. */
void claims_see(struct claims *claims, int64_t time_ns, const void *output);

#define CLAIMS_FATE 100

/* What became of one, as in `violated, first at 3.200 s; in all at 2 instants`. */
void claims_fate(const struct claims *claims, size_t i, char text[CLAIMS_FATE]);

/* A line for each, behind `who`: `assert "keeps off": held`. */
void claims_print(const struct claims *claims, FILE *file, const char *who);

/* `"keeps off" (wall.frob:12) was violated at 3.200 s`: says it on standard error, as an error. */
void claims_complain(const struct claims *claims);

void claims_close(struct claims *claims);

#endif
