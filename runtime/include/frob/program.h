/* frob/program.h -- how a host sees a compiled program.
 *
 * `frobc` writes, beside NAME.c and NAME.h, a table of this form for hosts
 * that do not know the program: the trace host (CSV in, CSV out), the
 * simulator, the robot host. The table and the program are one shared
 * object; hosts look up the symbol `frob_program`.
 *
 * Everything here is constant data. Offsets are in bytes from the start of
 * the program's input or output struct, at every depth of the tree. */
#ifndef FROB_PROGRAM_H
#define FROB_PROGRAM_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum frob_kind {
    FROB_BOOL,    /* C bool */
    FROB_INT,     /* int32_t */
    FROB_FLOAT,   /* double */
    FROB_SINGLE,  /* float */
    FROB_ROUNDED, /* double, of which the program sees the nearest float */
    FROB_PRODUCT, /* tuple, record or () */
    FROB_SUM,     /* uint8_t tag, and slots for the payloads */
    FROB_ARRAY,   /* like a tuple; the fields of its one constructor are the elements */
    FROB_IMAGE    /* const struct frob_image * (frob/image.h), good for the instant */
};

struct frob_value;

/* A component of a product, or an argument of a constructor. */
struct frob_field {
    const char *name; /* NULL for a tuple component or positional argument */
    const struct frob_value *value;
};

struct frob_constructor {
    const char *name; /* as in the source: "Just"; NULL for a tuple or array */
    int is_record;    /* fields are written {name = value} */
    size_t count;     /* of fields */
    const struct frob_field *fields;
};

/* One value inside the input or output struct. */
struct frob_value {
    enum frob_kind kind;
    size_t offset; /* of the bool, int32_t, double, float, pointer, or the sum's tag */
    int is_event;  /* a sum that is `Event a`: constructor 0 is NoEvent */
    size_t count;  /* constructors: 1 for a product or array, its tag is not stored */
    const struct frob_constructor *constructors;
};

/* Several modes, of which one runs at a time: a switch, or a task. */
struct frob_machine {
    const char *name;         /* from the source; unique in the program */
    size_t offset;            /* in the state, of the number of the mode that runs */
    size_t size;              /* of that number: 1 (uint8_t) or 4 (int32_t) */
    size_t count;             /* of modes */
    const char *const *modes; /* names, by number */
    size_t within;            /* 0, or n + 1: this one is in a mode of machine n, … */
    int32_t mode;             /* … the mode of this number, and is there only while it runs */
};

enum frob_control_kind {
    FROB_BUTTON, /* an event of () */
    FROB_HOLD,   /* a bool: a button is held down */
    FROB_KNOB,   /* a number, from least to most */
    FROB_TOGGLE, /* a bool */
    FROB_MAP,    /* an event of a place: two numbers, in metres, in the frame of odometry */
    FROB_CAMERA, /* an event of a frame (frob/camera.h): not the operator's, but the host's */
    FROB_TAGS    /* an event of the tags in a frame (frob/tags.h), likewise; its label is that
                  * of the camera, and " tags" */
};

/* Something on the operator's console; see frob/console.h. */
struct frob_control {
    enum frob_control_kind kind;
    const char *label;  /* unique in the program, in UTF-8 */
    const char *unit;   /* of a knob: "m/s"; "" without one */
    double least, most; /* of a knob; 0 and 1 of what is a bool */
    double first;       /* where a knob is, and whether a toggle is on, before it is touched */
    const struct frob_value *value; /* its part of the input */
};

/* What is fixed when a run starts. */
struct frob_param {
    const char *name;               /* "kTurn"; of another module perhaps "M.kTurn" */
    const char *unit;               /* as in brackets: "1/m", "1"; "" of a truth value */
    const struct frob_value *value; /* a bool, an int32_t, a double or a float, in the
                                     * struct of the parameters */
};

/* An assertion in the program; see `assert` in the language reference. */
struct frob_claim {
    const char *label; /* "keeps off the wall" */
    const char
        *column; /* of a trace, if it is shown there: "wallFollow.assert keeps off the wall" */
    const char *place; /* "wall_follow.frob:12" */
    int is_assumption;
    const struct frob_value *value;
    /* the verdict, within the output struct: NotAsked, Holds, Open or Fails; an event of
         * one where its signal function does not run at each instant; an array of such */
};

struct frob_program {
    unsigned abi;      /* FROB_PROGRAM_ABI */
    const char *name;  /* of the program */
    const char *robot; /* "pioneer", …; "" for a plain signal function */
    size_t state_size, input_size, output_size;
    const struct frob_value *input;
    const struct frob_value *output;
    void (*reset)(void *state, const void *params);
    void (*step)(void *state, const void *params, double dt, const void *input, void *output);
    unsigned (*arithmetic)(void); /* frob_arithmetic_faults, compiled as the program
                                   * is; and of floats, if it computes with them */
    const struct frob_value *result;
    /* of a program that ends: the event, part of its output, that occurs at
         * its end and from then on, with what it has ended with; else NULL. The
         * robot's output struct is at the beginning of the output. */
    const struct frob_machine *machines; /* each after the one it is within */
    size_t machine_count;
    const struct frob_value *probes;
    /* inner signals, a record within the output struct; NULL without any */
    const struct frob_control *console;
    /* what the operator is asked for, part of the input, where a robot's input struct
         * comes first */
    size_t control_count;
    const void *default_params; /* the struct of the parameters; NULL without any. What is
                                 * passed stays the same from a reset to the last step */
    size_t params_size;         /* of that struct */
    const struct frob_param *params;
    size_t param_count;
    const struct frob_claim *claims; /* if it was compiled for them to be judged; else none */
    size_t claim_count;
};

#define FROB_PROGRAM_ABI 9u

/* The symbol that hosts look up. */
#define FROB_PROGRAM_SYMBOL "frob_program"

#ifdef __cplusplus
}
#endif
#endif
