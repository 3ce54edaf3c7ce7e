#include "overrides.h"

#include "params_file.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A parameter's value in the ROS arguments, `-p NAME:=VALUE`. */
struct override {
    char *name, *value;
};

static char *copy(const char *text, size_t length)
{
    char *result = (char *)malloc(length + 1);
    if (result != NULL) {
        memcpy(result, text, length);
        result[length] = '\0';
    }
    return result;
}

struct found {
    struct override *all;
    size_t count, room;
    bool no_memory;
};

static void add_override(struct found *found, const char *name, size_t length, const char *value)
{
    struct override *override;
    if (found->count == found->room) {
        const size_t room = 2 * found->room + 16;
        struct override *all = (struct override *)realloc(found->all, room * sizeof *all);
        if (all == NULL) {
            found->no_memory = true;
            return;
        }
        found->all = all;
        found->room = room;
    }
    override = &found->all[found->count++];
    override->name = copy(name, length);
    override->value = copy(value, strlen(value));
    found->no_memory = found->no_memory || override->name == NULL || override->value == NULL;
}

static void add_from_file(void *context, const char *name, const char *value)
{
    add_override((struct found *)context, name, strlen(name), value);
}

/* Calls `take` with each ROS argument and the argument before it. */
static void each_argument(int argc, char **argv,
                          void (*take)(void *context, const char *before, const char *argument),
                          void *context)
{
    bool for_ros = false;
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--ros-args") == 0)
            for_ros = true;
        else if (strcmp(argv[i], "--") == 0)
            for_ros = false;
        if (for_ros)
            take(context, argv[i - 1], argv[i]);
    }
}

/* The full name of the node. */
struct node_name {
    char space[256], name[256], full[520];
};

/* Handles `-r __node:=NAME` and `-r __ns:=NAMESPACE`. */
static void take_name(void *context, const char *before, const char *argument)
{
    struct node_name *node = (struct node_name *)context;
    if (strcmp(before, "-r") != 0 && strcmp(before, "--remap") != 0)
        return;
    if (strncmp(argument, "__node:=", 8) == 0 || strncmp(argument, "__name:=", 8) == 0)
        snprintf(node->name, sizeof node->name, "%s", argument + 8);
    else if (strncmp(argument, "__ns:=", 6) == 0)
        snprintf(node->space, sizeof node->space, "%s", argument + 6);
}

struct search {
    struct found found;
    struct node_name node;
};

static void take_value(void *context, const char *before, const char *argument)
{
    struct search *search = (struct search *)context;
    const char *assign = strstr(argument, ":=");
    if (strcmp(before, "--params-file") == 0)
        params_file_read(argument, search->node.full, add_from_file, &search->found);
    else if ((strcmp(before, "-p") == 0 || strcmp(before, "--param") == 0) && assign != NULL)
        add_override(&search->found, argument, (size_t)(assign - argument), assign + 2);
}

/* Finds the values in the ROS arguments and in parameter files, in order. rcl reports
 * invalid arguments. */
static struct found overrides_in(int argc, char **argv, const char *program)
{
    struct search search;
    struct node_name *node = &search.node;
    memset(&search, 0, sizeof search);
    snprintf(node->name, sizeof node->name, "%s", program);
    each_argument(argc, argv, take_name, node);
    snprintf(node->full, sizeof node->full, "%s%s%s%s", node->space[0] == '/' ? "" : "/",
             node->space, node->space[0] == '\0' || strcmp(node->space, "/") == 0 ? "" : "/",
             node->name);
    each_argument(argc, argv, take_value, &search);
    return search.found;
}

/* Adds an option to the program's command line. Returns false if memory runs out. */
static bool add(struct overrides *result, const char *option, const char *name, const char *value)
{
    const size_t room = strlen(name) + strlen(value) + 2;
    char *setting = (char *)malloc(room);
    if (setting == NULL)
        return false;
    snprintf(setting, room, "%s=%s", name, value);
    result->argv[result->argc++] = (char *)(uintptr_t)option;
    result->argv[result->argc++] = setting;
    return true;
}

/* Applies an override. Returns false after an error, which it has reported unless memory ran
 * out. */
static bool override_one(struct overrides *result, const struct parameters *parameters,
                         const struct frob_program *program, const struct override *override)
{
    const struct parameter *p = parameters_find(parameters, override->name);
    char reason[1000];
    double value;
    if (p == NULL) {
        fprintf(stderr, "warning: %s has no parameter `%s`; --help lists its parameters\n",
                program->name, override->name);
        return true;
    }
    if (!p->is_fixed) {
        /* The node sets this control later (overrides_of_controls). */
        if (parameters_read(parameters, p, override->value, &value, reason, sizeof reason))
            return true;
        fprintf(stderr, "error: %s\n", reason);
        return false;
    }
    if (strcmp(p->name, "use_sim_time") != 0)
        return add(result, "--param", override->name, override->value);
    if (strcmp(override->value, "true") == 0)
        return add(result, "--set", "sim_time", "1");
    if (strcmp(override->value, "false") == 0)
        return true;
    fprintf(stderr, "error: the parameter `use_sim_time` must be true or false, not `%s`\n",
            override->value);
    return false;
}

struct overrides overrides_of(int argc, char **argv, const struct frob_program *program)
{
    const struct found found = overrides_in(argc, argv, program->name);
    struct overrides result = { 1, (char **)calloc(2 * (size_t)argc + 2 * found.count + 1,
                                                   sizeof *argv) };
    bool is_ours = true;
    const struct overrides failed = { 0, NULL };
    struct parameters parameters;
    if (result.argv == NULL || found.no_memory ||
        !parameters_of(&parameters, program, program->default_params, false)) {
        fprintf(stderr, "error: not enough memory\n");
        return failed;
    }
    result.argv[0] = argv[0];
    for (size_t i = 0; i < found.count; i++)
        if (!override_one(&result, &parameters, program, &found.all[i]))
            return failed;
    for (int i = 1; i < argc; i++) {
        is_ours = is_ours && strcmp(argv[i], "--ros-args") != 0;
        if (!is_ours || strcmp(argv[i], "--lifecycle") != 0)
            result.argv[result.argc++] = argv[i];
        else if (!add(&result, "--set", "lifecycle", "1"))
            return failed;
    }
    return result;
}

void overrides_of_controls(int argc, char **argv, const char *program,
                           const struct parameters *parameters,
                           void (*set)(void *context, struct parameter *parameter, double value),
                           void *context)
{
    const struct found found = overrides_in(argc, argv, program);
    for (size_t i = 0; !found.no_memory && i < found.count; i++) {
        struct parameter *p = parameters_find(parameters, found.all[i].name);
        char reason[1000];
        double value;
        if (p != NULL && !p->is_fixed &&
            parameters_read(parameters, p, found.all[i].value, &value, reason, sizeof reason))
            set(context, p, value);
    }
}
