/* params.h -- the values of a program's parameters in a run: those that it has by
 * default, those that a recording was made with, and those that are set. */
#ifndef FROB_HOST_PARAMS_H
#define FROB_HOST_PARAMS_H

#include <frob/program.h>
#include <frob/text.h>

#include <stdbool.h>

struct params {
    const struct frob_program *program;
    void *values; /* what the program's reset and step take */
    bool *set;    /* by option, which a recording does not change */
};

/* By default, but for those that options set: each NAME=NUMBER, or NAME=NUMBER[UNIT] with the
 * parameter's own unit. False without memory or with a wrong option, with a line on standard
 * error; close it then, too. */
bool params_open(struct params *params, const struct frob_program *program,
                 const char *const *options, size_t count);
void params_close(struct params *params);

/* What can be wrong with a setting, in a sentence. */
enum { PARAMS_WHY = 1000 };

enum params_result {
    PARAMS_SET,
    PARAMS_KEPT,    /* it is set by option, and another value was recorded */
    PARAMS_UNKNOWN, /* the program has no such parameter */
    PARAMS_WRONG    /* it has, and the text is no value of it, or of another unit */
};

/* What was recorded, in the form of an option; `why` has room for PARAMS_WHY. */
enum params_result params_read(struct params *params, const char *setting, char *why);

/* What a line before the header of a recording called `name` says, if it says something of
 * a parameter. A parameter that the program has not, or that an option has set to something
 * else, is told by a warning. False, with a line on standard error, for what is no value. */
bool params_recorded(struct params *params, const char *name, const char *line);

/* The number of a parameter, as it would be read; the unit comes after it in brackets. */
void params_write(struct frob_text *text, const struct frob_param *param, const void *values);

/* A recording begins with a line for each parameter, as `# param kTurn=4[1/m]`. The
 * functions tell how long such lines are, and write them. */
size_t params_room(const struct frob_program *program);
void params_head(struct frob_text *text, const struct frob_program *program, const void *values);

/* Of a line of a recording: its setting, or NULL if it is another. */
const char *params_of_line(const char *line);

#endif
