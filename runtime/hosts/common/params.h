/* params.h -- the values of a program's parameters in a run: defaults, values from a recording, and
 * values set by options. */
#ifndef FROB_HOST_PARAMS_H
#define FROB_HOST_PARAMS_H

#include <frob/program.h>
#include <frob/text.h>

#include <stdbool.h>

struct params {
    const struct frob_program *program;
    void *values; /* passed to the program's reset and step */
    bool *set;    /* set by an option, so recordings do not change it */
};

/* Starts with the defaults and applies the options, each NAME=NUMBER, or NAME=NUMBER[UNIT] with the
 * parameter's own unit. If memory runs out or an option is wrong, prints a line on standard error
 * and returns false. Even then, the caller must call params_close. */
bool params_open(struct params *params, const struct frob_program *program,
                 const char *const *options, size_t count);
void params_close(struct params *params);

/* Size of a message about a wrong setting. */
enum { PARAMS_WHY = 1000 };

enum params_result {
    PARAMS_SET,
    PARAMS_KEPT,    /* an option has set it to a value other than the recorded one */
    PARAMS_UNKNOWN, /* the program has no such parameter */
    PARAMS_WRONG    /* the text is not a value of the parameter, or has a different unit */
};

/* Reads a recorded value, which has the form of an option. `why` must have room for PARAMS_WHY
 * bytes. */
enum params_result params_read(struct params *params, const char *setting, char *why);

/* Reads a line before the header of the recording `name`, if the line is about a parameter. Prints
 * a warning if the program has no such parameter, or if an option has set it to a different value.
 * If the text is not a value, prints a line on standard error and returns false. */
bool params_recorded(struct params *params, const char *name, const char *line);

/* Appends the parameter's number in the form that params_read accepts, without the unit in
 * brackets. */
void params_write(struct frob_text *text, const struct frob_param *param, const void *values);

/* A recording begins with a line for each parameter, such as `# param kTurn=4[1/m]`. params_room
 * returns the maximum total length of these lines, and params_head appends them. */
size_t params_room(const struct frob_program *program);
void params_head(struct frob_text *text, const struct frob_program *program, const void *values);

/* Returns the setting in a line of a recording; NULL if the line is not about a parameter. */
const char *params_of_line(const char *line);

#endif
