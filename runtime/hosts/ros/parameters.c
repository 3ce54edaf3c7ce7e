#include "parameters.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char sim_time[] = "use_sim_time";

static double number_in(const struct frob_value *value, const void *values)
{
    const char *at = (const char *)values + value->offset;
    double number;
    float single;
    int32_t whole;
    bool truth;
    switch (value->kind) {
    case FROB_BOOL: memcpy(&truth, at, sizeof truth); return truth ? 1.0 : 0.0;
    case FROB_INT: memcpy(&whole, at, sizeof whole); return (double)whole;
    case FROB_SINGLE: memcpy(&single, at, sizeof single); return (double)single;
    default: memcpy(&number, at, sizeof number); return number;
    }
}

/* Returns the unit, or "" for a number without one. */
static const char *unit_of(const char *unit)
{
    return strcmp(unit, "1") == 0 ? "" : unit;
}

static struct parameter of_param(const struct frob_program *program, size_t i, const void *values)
{
    const struct frob_param *param = &program->params[i];
    struct parameter p;
    memset(&p, 0, sizeof p);
    p.name = param->name;
    p.unit = unit_of(param->unit);
    p.is_fixed = true;
    p.control = program->control_count;
    p.value = number_in(param->value, values);
    p.least = -INFINITY;
    p.most = INFINITY;
    switch (param->value->kind) {
    case FROB_BOOL: p.type = PARAMETER_BOOL; break;
    case FROB_INT:
        p.type = PARAMETER_INTEGER;
        p.least = INT32_MIN;
        p.most = INT32_MAX;
        break;
    default: p.type = PARAMETER_DOUBLE; break;
    }
    return p;
}

static struct parameter of_control(const struct frob_program *program, size_t i)
{
    const struct frob_control *control = &program->console[i];
    struct parameter p;
    memset(&p, 0, sizeof p);
    p.name = control->label;
    p.unit = unit_of(control->unit);
    p.control = i;
    p.type = control->kind == FROB_TOGGLE ? PARAMETER_BOOL : PARAMETER_DOUBLE;
    p.least = control->least;
    p.most = control->most;
    p.value = control->first;
    return p;
}

bool parameters_of(struct parameters *parameters, const struct frob_program *program,
                   const void *values, bool use_sim_time)
{
    struct parameter clock;
    memset(&clock, 0, sizeof clock);
    clock.name = sim_time;
    clock.unit = "";
    clock.type = PARAMETER_BOOL;
    clock.is_fixed = true;
    clock.control = program->control_count;
    clock.value = use_sim_time ? 1.0 : 0.0;
    parameters->count = 0;
    parameters->each = (struct parameter *)calloc(program->param_count + program->control_count + 1,
                                                  sizeof *parameters->each);
    if (parameters->each == NULL)
        return false;
    for (size_t i = 0; i < program->param_count; i++)
        parameters->each[parameters->count++] = of_param(program, i, values);
    for (size_t i = 0; i < program->control_count; i++) {
        const enum frob_control_kind kind = program->console[i].kind;
        /* A parameter hides a control of the same name. */
        if ((kind == FROB_KNOB || kind == FROB_TOGGLE) &&
            parameters_find(parameters, program->console[i].label) == NULL)
            parameters->each[parameters->count++] = of_control(program, i);
    }
    if (parameters_find(parameters, sim_time) == NULL)
        parameters->each[parameters->count++] = clock;
    return true;
}

struct parameter *parameters_find(const struct parameters *parameters, const char *name)
{
    for (size_t i = 0; i < parameters->count; i++)
        if (strcmp(parameters->each[i].name, name) == 0)
            return &parameters->each[i];
    return NULL;
}

struct parameter *parameters_of_control(const struct parameters *parameters, size_t control)
{
    for (size_t i = 0; i < parameters->count; i++)
        if (!parameters->each[i].is_fixed && parameters->each[i].control == control)
            return &parameters->each[i];
    return NULL;
}

const char *parameters_type_name(int type)
{
    static const char *const names[] = { "not set",     "bool",          "integer",
                                         "double",      "string",        "bytes",
                                         "bool array",  "integer array", "double array",
                                         "string array" };
    return type >= 0 && type < (int)(sizeof names / sizeof names[0]) ? names[type] : "unknown";
}

/* Appends the names of all parameters. */
static void list(const struct parameters *parameters, char *text, size_t room)
{
    size_t length = strlen(text);
    for (size_t i = 0; i < parameters->count && length < room; i++) {
        int written = snprintf(text + length, room - length, "%s `%s`",
                               i == 0 ? "; its parameters are" : ",", parameters->each[i].name);
        length += written > 0 ? (size_t)written : 0;
    }
}

/* Explains how to set a read-only parameter. */
static void refuse_fixed(const struct parameter *p, char *reason, size_t room)
{
    if (strcmp(p->name, sim_time) == 0)
        snprintf(reason, room,
                 "`use_sim_time` is fixed during a run: restart the node with `--ros-args -p "
                 "use_sim_time:=%s`",
                 p->value > 0.0 ? "false" : "true");
    else
        snprintf(reason, room,
                 "`%s` is fixed during a run: restart the node with `--ros-args -p %s:=VALUE`, or "
                 "make it a knob on the program's console",
                 p->name, p->name);
}

bool parameters_convert(const struct parameters *parameters, const struct parameter *p,
                        const char *name, const struct parameter_request *request, double *value,
                        char *reason, size_t room)
{
    const char *space;
    if (p == NULL) {
        snprintf(reason, room, "the node has no parameter `%.100s`", name);
        list(parameters, reason, room);
        return false;
    }
    if (p->is_fixed) {
        refuse_fixed(p, reason, room);
        return false;
    }
    if (request->type == (int)PARAMETER_BOOL && p->type == PARAMETER_BOOL) {
        *value = request->truth ? 1.0 : 0.0;
        return true;
    }
    /* A number may be given as an integer, such as 3 for 3.0. */
    if (p->type != PARAMETER_DOUBLE ||
        (request->type != (int)PARAMETER_DOUBLE && request->type != (int)PARAMETER_INTEGER)) {
        snprintf(reason, room, "`%s` has the type %s, but the value has the type %s", p->name,
                 parameters_type_name((int)p->type), parameters_type_name(request->type));
        return false;
    }
    *value = request->type == (int)PARAMETER_INTEGER ? (double)request->integer : request->number;
    if (*value >= p->least && *value <= p->most)
        return true;
    space = p->unit[0] == '\0' ? "" : " ";
    snprintf(reason, room, "`%s` must be a number from %g to %g%s%s, not %g", p->name, p->least,
             p->most, space, p->unit, *value);
    return false;
}

void parameters_describe(const struct parameter *p, char *text, size_t room)
{
    if (strcmp(p->name, sim_time) == 0)
        snprintf(text, room, "follow the time of the topic /clock");
    else if (p->is_fixed)
        snprintf(text, room, "%s%sparameter of the program", p->unit,
                 p->unit[0] != '\0' ? "; " : "");
    else
        snprintf(text, room, "%s%s%s on the program's console", p->unit,
                 p->unit[0] != '\0' ? "; " : "", p->type == PARAMETER_BOOL ? "toggle" : "knob");
}

bool parameters_read(const struct parameters *parameters, const struct parameter *p,
                     const char *text, double *value, char *reason, size_t room)
{
    struct parameter_request request;
    char *end;
    memset(&request, 0, sizeof request);
    request.type = 4; /* a string, unless the text is a number or a Bool */
    request.number = strtod(text, &end);
    if (end != text && *end == '\0')
        request.type = (int)PARAMETER_DOUBLE;
    else if (strcmp(text, "true") == 0 || strcmp(text, "false") == 0)
        request.type = (int)PARAMETER_BOOL;
    request.truth = strcmp(text, "true") == 0;
    return parameters_convert(parameters, p, p->name, &request, value, reason, room);
}
