/* frob/program.h -- the interface between a host and a compiled program.
 *
 * `frobc` writes, next to NAME.c and NAME.h, a table of this form for hosts that work with any
 * program: the trace host (CSV in, CSV out), the simulator and the robot host. The table and the
 * program are compiled into one shared object; hosts look up the symbol `frob_program`.
 *
 * Everything here is constant data. All offsets, at every depth of the tree, are in bytes from the
 * start of the program's input or output struct. */
#ifndef FROB_PROGRAM_H
#define FROB_PROGRAM_H

#include <stdbool.h>
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
    FROB_ROUNDED, /* double, rounded by the program to the nearest float */
    FROB_PRODUCT, /* a tuple, a record, or () */
    FROB_SUM,     /* uint8_t tag, and slots for the arguments of the constructors */
    FROB_ARRAY,   /* like a tuple: the elements are the fields of the only constructor */
    FROB_IMAGE    /* const struct frob_image * (frob/image.h), valid during the instant */
};

struct frob_value;

/* A component of a product, or an argument of a constructor. */
struct frob_field {
    const char *name; /* NULL for a tuple component or positional argument */
    const struct frob_value *value;
};

struct frob_constructor {
    const char *name; /* the name in the source, such as "Just"; NULL for a tuple or array */
    int is_record;    /* whether the fields are written {name = value} in Frob */
    size_t count;     /* number of fields */
    const struct frob_field *fields;
};

/* A value inside the input or output struct. */
struct frob_value {
    enum frob_kind kind;
    size_t offset; /* position of the bool, int32_t, double, float or pointer, or of a sum's tag */
    int is_event;  /* whether it is a sum of type `Event a`, in which constructor 0 is NoEvent */
    /* Number of constructors: 1 for a product or an array, neither of which stores a tag. */
    size_t count;
    const struct frob_constructor *constructors;
};

/* A state machine, which runs one mode at a time: a switch or a task. */
struct frob_machine {
    const char *name;         /* name from the source; unique in the program */
    size_t offset;            /* offset, in the state struct, of the running mode's number */
    size_t size;              /* size of that number: 1 (uint8_t) or 4 (int32_t) */
    size_t count;             /* number of modes */
    const char *const *modes; /* names of the modes, by number */
    /* 0, or n + 1 if this machine is part of a mode of machine n. It then exists only while that
     * mode runs. */
    size_t within;
    int32_t mode; /* number of the mode that contains this machine */
};

enum frob_control_kind {
    FROB_BUTTON, /* an event with the value () */
    FROB_HOLD,   /* a bool: whether a button is held down */
    FROB_KNOB,   /* a number from `least` to `most` */
    FROB_TOGGLE, /* a bool */
    FROB_MAP,    /* an event with a position: two numbers, in metres, in the odometry frame */
    FROB_CAMERA, /* an event with a frame (frob/camera.h), set by the host, not by the operator */
    /* An event with the tags in a frame (frob/tags.h), also set by the host. Its label is the
     * camera's label followed by " tags". */
    FROB_TAGS,
    /* An event with a scan of a lidar (frob/lidar.h), set by the host. Its label is the lidar's
     * name and the number of directions. */
    FROB_LIDAR,
    FROB_IMU /* an event with a reading of an inertial measurement unit (frob/imu.h), set by the
              * host */
};

/* A control on the operator's console; see frob/console.h. */
struct frob_control {
    enum frob_control_kind kind;
    const char *label;              /* unique in the program, in UTF-8 */
    const char *unit;               /* unit of a knob: "m/s"; "" if it has none */
    double least, most;             /* range of a knob; 0 and 1 if the value is a bool */
    double first;                   /* initial value of a knob or toggle */
    const struct frob_value *value; /* the control's value, which is part of the input */
    const char *place;              /* place in the source that requests it:
                                     * "wall_follow.frob:12" */
};

/* A parameter of the program, which is fixed when a run starts. */
struct frob_param {
    const char *name;               /* "kTurn", or "M.kTurn" if it is from the module M */
    const char *unit;               /* the unit as in the source: "1/m", "1"; "" for a bool */
    const struct frob_value *value; /* a bool, int32_t, double or float in the parameter struct */
};

/* An assertion in the program; see `assert` in the language reference. */
struct frob_claim {
    const char *label; /* "keeps off the wall" */
    /* Its column in a trace (if the trace has one), without `probe.`: "wallFollow.assert keeps off
     * the wall". */
    const char *column;
    const char *place; /* "wall_follow.frob:12" */
    int is_assumption;
    /* The verdict within the output struct: NotAsked, Holds, Open or Fails. It is an event that
     * carries the verdict if the signal function does not run at every instant, and an array if
     * there are several instances. */
    const struct frob_value *value;
};

/* A topic of a ROS 2 node. */
struct frob_topic {
    const char *field; /* field of the program's input or output, which are records */
    const char *name;  /* before remapping: "cmd_vel" */
    const char *type;  /* "geometry_msgs/msg/Twist" */
    int is_counted;    /* whether the value is an event with a Counted */
    int is_command;    /* whether an all-zero message stops the controlled device */
};

/* The strings that represent an enumeration in ROS 2 messages. */
struct frob_texts {
    /* The constructors of a value of this type in the program's input or output. Each value has its
     * own table of constructors, so the pointer identifies the value. */
    const struct frob_constructor *constructors;
    const char *type;         /* name from the source: "Mode" */
    const char *const *texts; /* one string for each constructor */
};

/* A program that is a ROS 2 node with topics of its own. */
struct frob_node {
    double rate_hz;
    const struct frob_topic *inputs;
    size_t input_count;
    const struct frob_topic *outputs;
    size_t output_count;
    const struct frob_texts *texts;
    size_t text_count;
};

struct frob_program {
    unsigned abi;      /* FROB_PROGRAM_ABI */
    const char *name;  /* name of the program */
    const char *robot; /* "pioneer", …; "" for a program without a robot */
    size_t state_size, input_size, output_size;
    const struct frob_value *input;
    const struct frob_value *output;
    void (*reset)(void *state, const void *params);
    /* Runs one instant. dt_ns is the time since the previous instant, and dt is the same time in
     * seconds, dt_ns / 1e9. Both must be 0 in the first instant after a reset. */
    void (*step)(void *state, const void *params, int64_t dt_ns, double dt, const void *input,
                 void *output);
    /* Returns whether the number of each running mode is valid. If not, memory has been corrupted:
     * hosts then stop the robot, and do not call step again before the next reset. */
    bool (*is_valid)(const void *state);
    /* frob_arithmetic_faults, compiled with the program's options. It also checks floats if the
     * program computes with them. */
    unsigned (*arithmetic)(void);
    /* For a program that ends, an event within the output that occurs when it ends and at each
     * later instant, with the program's result; otherwise NULL. The robot's output struct is at the
     * beginning of the output. */
    const struct frob_value *result;
    const struct frob_machine *machines; /* the machines; a machine that is part of another one
                                          * comes after it */
    size_t machine_count;
    /* Inner signals, as a record within the output struct; NULL if there are none. */
    const struct frob_value *probes;
    /* The controls of the operator's console, which are part of the input. The robot's input struct
     * is at the beginning of the input. */
    const struct frob_control *console;
    size_t control_count;
    /* Default values in the parameter struct; NULL if there are no parameters. The struct passed to
     * reset and step must not change between a reset and the last step. */
    const void *default_params;
    size_t params_size; /* size of the parameter struct */
    const struct frob_param *params;
    size_t param_count;
    /* The assertions, if the program was compiled to check them; otherwise none. */
    const struct frob_claim *claims;
    size_t claim_count;
    const struct frob_node *node; /* the topics; NULL for a program without topics of its own */
};

#define FROB_PROGRAM_ABI 14u

/* The end of a host's message about an invalid state. The part before it names the program or its
 * process. */
#define FROB_DAMAGED_STATE                                                        \
    "the number of a running mode is invalid; if the program calls C functions, " \
    "check that they write only to their own memory"

/* Symbol that hosts look up. */
#define FROB_PROGRAM_SYMBOL "frob_program"

#ifdef __cplusplus
}
#endif
#endif
