#include "params.h"

#include <frob/cell.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char prefix[] = "# param ";

void params_close(struct params *params)
{
    free(params->values);
    free(params->set);
    params->values = NULL;
    params->set = NULL;
}

/* Appends the names of the program's parameters, for a message. */
static void list(const struct frob_program *program, char *why, size_t length)
{
    const char *before = "; the program has";
    if (program->param_count == 0)
        snprintf(why + length, PARAMS_WHY - length, "; the program has none");
    for (size_t i = 0; i < program->param_count && length < PARAMS_WHY; i++) {
        int written =
            snprintf(why + length, PARAMS_WHY - length, "%s `%s`", before, program->params[i].name);
        length += written > 0 ? (size_t)written : 0;
        before = ",";
    }
}

static void describe(const struct frob_param *param, char *text, size_t size)
{
    const enum frob_kind kind = param->value->kind;
    if (kind == FROB_BOOL)
        snprintf(text, size, "true or false");
    else
        snprintf(text, size, "a %snumber in %s", kind == FROB_INT ? "whole " : "", param->unit);
}

/* Splits the text into the number and the unit in brackets after it. */
static bool take_apart(const char *text, char *number, size_t size, const char **unit)
{
    const size_t length = strcspn(text, "[");
    *unit = NULL;
    if (length >= size)
        return false;
    memcpy(number, text, length);
    number[length] = '\0';
    if (text[length] == '[') {
        if (text[strlen(text) - 1] != ']')
            return false;
        *unit = text + length + 1;
    }
    return true;
}

static bool is_unit_of(const struct frob_param *param, const char *unit)
{
    const size_t length = strlen(param->unit);
    return unit == NULL ||
           (strncmp(unit, param->unit, length) == 0 && strcmp(unit + length, "]") == 0);
}

static bool is_nan(const struct frob_param *param, const void *values)
{
    const char *at = (const char *)values + param->value->offset;
    double d = 0.0;
    float f = 0.0F;
    if (param->value->kind == FROB_FLOAT)
        memcpy(&d, at, sizeof d);
    else if (param->value->kind == FROB_SINGLE)
        memcpy(&f, at, sizeof f);
    return d != d || f != f;
}

static size_t width(const struct frob_param *param)
{
    switch (param->value->kind) {
    case FROB_BOOL: return sizeof(bool);
    case FROB_INT: return sizeof(int32_t);
    case FROB_SINGLE: return sizeof(float);
    default: return sizeof(double);
    }
}

static enum params_result read_value(struct params *params, size_t i, const char *text, char *why)
{
    const struct frob_param *param = &params->program->params[i];
    char number[200], expected[200], before[sizeof(double)];
    char *at = (char *)params->values + param->value->offset;
    const char *unit;
    struct frob_cell_error error;
    bool ok = take_apart(text, number, sizeof number, &unit);
    describe(param, expected, sizeof expected);
    if (ok && !is_unit_of(param, unit)) {
        snprintf(why, PARAMS_WHY, "the parameter `%s` is %s, but `%s` has a different unit",
                 param->name, expected, text);
        return PARAMS_WRONG;
    }
    memcpy(before, at, width(param));
    ok = ok && frob_cell_read(number, param->value, params->values, NULL, &error);
    if (!ok || is_nan(param, params->values)) {
        memcpy(at, before, width(param));
        snprintf(why, PARAMS_WHY, "the parameter `%s` is %s, not `%s`", param->name, expected,
                 text);
        return PARAMS_WRONG;
    }
    return PARAMS_SET;
}

/* Returns the index of the parameter that a setting names; the number of parameters if there is
 * none. */
static size_t find(const struct frob_program *program, const char *setting)
{
    const size_t length = strcspn(setting, "=");
    size_t i = 0;
    while (i < program->param_count && (strlen(program->params[i].name) != length ||
                                        strncmp(program->params[i].name, setting, length) != 0))
        i++;
    return i;
}

/* Compares a recorded value with that of an option, which takes precedence. */
static enum params_result keep(const struct params *params, size_t i, const char *text, char *why)
{
    struct frob_text now;
    char room[200];
    now = frob_text_in(room, sizeof room);
    params_write(&now, &params->program->params[i], params->values);
    if (strcmp(room, text) == 0)
        return PARAMS_SET;
    snprintf(why, PARAMS_WHY,
             "the parameter `%s` is %s, as set by the option, but it was %.100s in the recording",
             params->program->params[i].name, room, text);
    return PARAMS_KEPT;
}

enum params_result params_read(struct params *params, const char *setting, char *why)
{
    const size_t i = find(params->program, setting);
    const size_t length = strcspn(setting, "=");
    int written;
    if (setting[length] == '\0') {
        snprintf(why, PARAMS_WHY, "write a parameter as NAME=VALUE, not `%.100s`", setting);
        return PARAMS_WRONG;
    }
    if (i < params->program->param_count)
        return params->set[i] ? keep(params, i, setting + length + 1, why)
                              : read_value(params, i, setting + length + 1, why);
    written = snprintf(why, PARAMS_WHY, "the program has no parameter `%.*s`",
                       length > 100 ? 100 : (int)length, setting);
    if (written > 0)
        list(params->program, why, (size_t)written);
    return PARAMS_UNKNOWN;
}

static bool set(struct params *params, const char *setting)
{
    char why[PARAMS_WHY];
    const size_t i = find(params->program, setting);
    params->set[i] = false; /* the last option wins */
    if (params_read(params, setting, why) != PARAMS_SET) {
        fprintf(stderr, "error: %s\n", why);
        return false;
    }
    params->set[i] = true;
    return true;
}

bool params_open(struct params *params, const struct frob_program *program,
                 const char *const *options, size_t count)
{
    params->program = program;
    params->values = calloc(1, program->params_size + 1);
    params->set = (bool *)calloc(program->param_count + 1, sizeof *params->set);
    if (params->values == NULL || params->set == NULL) {
        fprintf(stderr, "error: not enough memory for the program's parameters\n");
        return false;
    }
    if (program->params_size > 0)
        memcpy(params->values, program->default_params, program->params_size);
    for (size_t i = 0; i < count; i++)
        if (!set(params, options[i]))
            return false;
    return true;
}

bool params_recorded(struct params *params, const char *name, const char *line)
{
    char why[PARAMS_WHY];
    const char *setting = params_of_line(line);
    switch (setting == NULL ? PARAMS_SET : params_read(params, setting, why)) {
    case PARAMS_SET: return true;
    case PARAMS_KEPT:
    case PARAMS_UNKNOWN: fprintf(stderr, "warning: %s: %s\n", name, why); return true;
    case PARAMS_WRONG: break;
    }
    fprintf(stderr, "error: %s: %s; to override the recorded value, use `--param`\n", name, why);
    return false;
}

/* Writes the number with the fewest digits that read back as the same value. */
static void write_number(struct frob_text *text, const struct frob_param *param, const void *values)
{
    const bool is_double = param->value->kind == FROB_FLOAT;
    const char *at = (const char *)values + param->value->offset;
    char room[40];
    double x;
    float single;
    if (!is_double && param->value->kind != FROB_SINGLE) {
        frob_cell_write(text, param->value, values);
        return;
    }
    memcpy(&single, at, sizeof single);
    x = (double)single;
    if (is_double)
        memcpy(&x, at, sizeof x);
    for (int digits = is_double ? 15 : 6; digits <= (is_double ? 17 : 9); digits++) {
        double read;
        snprintf(room, sizeof room, "%.*g", digits, x);
        read = strtod(room, NULL);
        if ((is_double ? read : (double)(float)read) == x)
            break;
    }
    frob_text_add(text, room);
}

void params_write(struct frob_text *text, const struct frob_param *param, const void *values)
{
    write_number(text, param, values);
    if (param->unit[0] != '\0' && strcmp(param->unit, "1") != 0) {
        frob_text_add(text, "[");
        frob_text_add(text, param->unit);
        frob_text_add(text, "]");
    }
}

size_t params_room(const struct frob_program *program)
{
    size_t room = 1;
    for (size_t i = 0; i < program->param_count; i++) {
        const struct frob_param *param = &program->params[i];
        room += sizeof prefix + strlen(param->name) + strlen(param->unit) +
                frob_cell_room(param->value) + 4;
    }
    return room;
}

void params_head(struct frob_text *text, const struct frob_program *program, const void *values)
{
    for (size_t i = 0; i < program->param_count; i++) {
        frob_text_add(text, prefix);
        frob_text_add(text, program->params[i].name);
        frob_text_add(text, "=");
        params_write(text, &program->params[i], values);
        frob_text_add(text, "\n");
    }
}

const char *params_of_line(const char *line)
{
    const size_t length = sizeof prefix - 1;
    return strncmp(line, prefix, length) == 0 ? line + length : NULL;
}
