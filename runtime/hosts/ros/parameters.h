/* parameters.h -- the parameters of the node that other nodes can read and set.
 *
 * A program's parameters are fixed during a run, so they are read-only. The knobs and toggles of
 * its console can be set at any time. The node also has the parameter use_sim_time, like every
 * node. */
#ifndef FROB_HOST_ROS_PARAMETERS_H
#define FROB_HOST_ROS_PARAMETERS_H

#include <frob/program.h>

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The types of rcl_interfaces/msg/ParameterType that occur here. */
enum parameter_type {
    PARAMETER_UNSET = 0,
    PARAMETER_BOOL = 1,
    PARAMETER_INTEGER = 2,
    PARAMETER_DOUBLE = 3
};

struct parameter {
    const char *name;
    enum parameter_type type;
    const char *unit; /* the unit; "" if there is none */
    bool is_fixed;    /* read-only */
    size_t control;   /* index in the program's console; `control_count` if the parameter is not a
                       * control */
    double least, most;
    double value; /* 0 or 1 for a bool; a whole number for an integer */
};

struct parameters {
    struct parameter *each;
    size_t count;
};

/* A value as it arrives in a request. */
struct parameter_request {
    int type; /* a value of rcl_interfaces/msg/ParameterType, possibly a type that no parameter
               * has */
    bool truth;
    int64_t integer;
    double number;
};

/* Determines the parameters of a program. `values`: its parameter struct. Returns false if memory
 * runs out. */
bool parameters_of(struct parameters *parameters, const struct frob_program *program,
                   const void *values, bool use_sim_time);

/* Returns NULL if there is no parameter with this name. */
struct parameter *parameters_find(const struct parameters *parameters, const char *name);

/* Returns the parameter of a control; NULL if it has none. */
struct parameter *parameters_of_control(const struct parameters *parameters, size_t control);

/* Converts a requested value of the parameter `name`. `parameter` is the parameter with this name,
 * or NULL. Returns false, with a reason, if the parameter cannot have this value. */
bool parameters_convert(const struct parameters *parameters, const struct parameter *parameter,
                        const char *name, const struct parameter_request *request, double *value,
                        char *reason, size_t room);

/* Describes the parameter: its unit, and how to set it. */
void parameters_describe(const struct parameter *parameter, char *text, size_t room);

/* Writes the name of a type. */
const char *parameters_type_name(int type);

/* Parses the text of a value, as in `-p NAME:=VALUE`. Returns false, with a reason, if the
 * parameter cannot have this value. */
bool parameters_read(const struct parameters *parameters, const struct parameter *parameter,
                     const char *text, double *value, char *reason, size_t room);

#endif
