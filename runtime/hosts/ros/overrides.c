#include "overrides.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool has_param(const struct frob_program *program, const char *name, size_t length)
{
    for (size_t i = 0; i < program->param_count; i++)
        if (strlen(program->params[i].name) == length &&
            strncmp(program->params[i].name, name, length) == 0)
            return true;
    return false;
}

/* Reports a value that the program does not use. */
static void tell_unused(const struct frob_program *program, const char *name, int length)
{
    if (length == 12 && strncmp(name, "use_sim_time", 12) == 0)
        fprintf(stderr,
                "warning: use_sim_time is not supported: the steps of %s follow the clock "
                "of this machine, not /clock\n",
                program->name);
    else
        fprintf(stderr, "warning: %s has no parameter `%.*s`; --help lists its parameters\n",
                program->name, length, name);
}

/* Returns NAME=VALUE for an argument NAME:=VALUE; NULL if the program does not use it. */
static char *setting_of(const struct frob_program *program, const char *argument)
{
    const char *assign = strstr(argument, ":=");
    const size_t length = assign != NULL ? (size_t)(assign - argument) : 0;
    char *setting;
    if (assign == NULL)
        return NULL; /* rcl reports it */
    if (!has_param(program, argument, length)) {
        tell_unused(program, argument, (int)length);
        return NULL;
    }
    setting = (char *)malloc(strlen(argument));
    if (setting != NULL)
        sprintf(setting, "%.*s=%s", (int)length, argument, assign + 2);
    return setting;
}

struct overrides overrides_of(int argc, char **argv, const struct frob_program *program)
{
    static char option[] = "--param";
    struct overrides result = { 1, (char **)calloc(3 * (size_t)argc + 1, sizeof *argv) };
    bool for_ros = false;
    if (result.argv == NULL)
        return result;
    result.argv[0] = argv[0];
    for (int i = 1; i < argc; i++) {
        char *setting = NULL;
        if (strcmp(argv[i], "--ros-args") == 0)
            for_ros = true;
        else if (strcmp(argv[i], "--") == 0)
            for_ros = false;
        else if (for_ros && (strcmp(argv[i - 1], "-p") == 0 || strcmp(argv[i - 1], "--param") == 0))
            setting = setting_of(program, argv[i]);
        if (setting != NULL) {
            result.argv[result.argc++] = option;
            result.argv[result.argc++] = setting;
        }
    }
    for (int i = 1; i < argc; i++)
        result.argv[result.argc++] = argv[i];
    return result;
}
