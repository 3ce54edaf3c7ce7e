/* A wall follower written by hand, in the form of a compiled program: the paper's control law
 * (section 3) for a wall on the left, with held and smoothed sonar signals. It tests the
 * simulator and its host without the compiler. */
#include <frob/arithmetic.h>
#include <frob/pioneer.h>
#include <frob/program.h>

#include <math.h>
#include <string.h>

static const double keep = 0.5;        /* m, distance from the wall */
static const double v_max = 0.4;       /* m/s */
static const double sin_theta = 0.5;   /* sine of the largest angle to the wall */
static const double k_front = 1.2;     /* 1/s */
static const double k_side = 1.0;      /* 1/s */
static const double k_turn = 5.0;      /* 1/m */
static const double smoothing_s = 0.5; /* time constant */

struct state {
    int started;
    double front[2], side[3];  /* m, last echoes */
    double smooth_side, slope; /* m, m/s */
};

static double limit(double x, double y)
{
    return fmax(-x, fmin(x, y));
}

/* Stores the last echo of transducer `i`. */
#define HOLD(last, i)                    \
    do {                                 \
        if (input->sonar[i].tag == 1)    \
            (last) = input->sonar[i].f0; \
    } while (0)

static void reset(void *self, const void *params)
{
    struct state *s = (struct state *)self;
    (void)params;
    memset(s, 0, sizeof *s);
    s->front[0] = s->front[1] = 5.0;
    s->side[0] = s->side[1] = s->side[2] = keep;
    s->smooth_side = keep;
}

/* How far to the left of transducer 0 an echo came from, assuming that it came from the edge of
 * the cone nearer to the side; exact along a straight wall. */
static double to_the_side(double range, double y, double angle)
{
    return y + range * sin(angle) - 0.136;
}

static bool is_valid(const void *self)
{
    (void)self;
    return true;
}

static void step(void *self, const void *params, int64_t dt_ns, double dt, const void *in,
                 void *out)
{
    struct state *s = (struct state *)self;
    const struct frob_pioneer_input *input = (const struct frob_pioneer_input *)in;
    struct frob_pioneer_output *output = (struct frob_pioneer_output *)out;
    double front, side, v_now;
    (void)params;
    (void)dt_ns;
    HOLD(s->front[0], 3);
    HOLD(s->front[1], 4);
    HOLD(s->side[0], 0);
    HOLD(s->side[1], 1);
    HOLD(s->side[2], 2);
    front = fmin(s->front[0], s->front[1]);
    /* The angles are 90, 50 + 12 and 30 + 12 degrees. */
    side = fmin(s->side[0], fmin(to_the_side(s->side[1], 0.119, 1.0821041),
                                 to_the_side(s->side[2], 0.078, 0.7330383)));
    if (dt > 0.0) {
        s->slope = (side - s->smooth_side) / (smoothing_s + dt);
        s->smooth_side += s->slope * dt;
    }
    v_now = (input->leftWheel + input->rightWheel) / 2;
    output->forward = limit(v_max, k_front * (front - keep));
    output->turn = k_turn * (limit(sin_theta * v_now, k_side * (s->smooth_side - keep)) + s->slope);
}

#define AT(member) offsetof(struct frob_pioneer_input, member)
#define NUMBER(name, where) static const struct frob_value name = { FROB_FLOAT, where, 0, 0, NULL };
#define TRUTH(name, where) static const struct frob_value name = { FROB_BOOL, where, 0, 0, NULL };
#define COUNT(fields) (sizeof(fields) / sizeof(fields)[0])
#define PRODUCT(name, fields)                                                                      \
    static const struct frob_constructor name##_constructor = { #name, 1, COUNT(fields), fields }; \
    static const struct frob_value name = { FROB_PRODUCT, 0, 0, 1, &name##_constructor };
#define ECHO(i)                                                                       \
    NUMBER(distance_##i, AT(sonar[i].f0))                                             \
    static const struct frob_field echo_##i##_fields[] = { { NULL, &distance_##i } }; \
    static const struct frob_constructor echo_##i##_constructors[] = {                \
        { "NoEvent", 0, 0, NULL }, { "Event", 0, 1, echo_##i##_fields }               \
    };                                                                                \
    static const struct frob_value echo_##i = { FROB_SUM, AT(sonar[i].tag), 1, 2,     \
                                                echo_##i##_constructors };

/* clang-format off */
ECHO(0) ECHO(1) ECHO(2) ECHO(3) ECHO(4) ECHO(5) ECHO(6) ECHO(7)
ECHO(8) ECHO(9) ECHO(10) ECHO(11) ECHO(12) ECHO(13) ECHO(14) ECHO(15)
    /* clang-format on */

    static const struct frob_field sonar_elements[] = {
        { NULL, &echo_0 },  { NULL, &echo_1 },  { NULL, &echo_2 },  { NULL, &echo_3 },
        { NULL, &echo_4 },  { NULL, &echo_5 },  { NULL, &echo_6 },  { NULL, &echo_7 },
        { NULL, &echo_8 },  { NULL, &echo_9 },  { NULL, &echo_10 }, { NULL, &echo_11 },
        { NULL, &echo_12 }, { NULL, &echo_13 }, { NULL, &echo_14 }, { NULL, &echo_15 },
    };
static const struct frob_constructor sonar_constructor = { NULL, 0, COUNT(sonar_elements),
                                                           sonar_elements };
static const struct frob_value sonar = { FROB_ARRAY, 0, 0, 1, &sonar_constructor };

NUMBER(x, AT(odometry.position.x))
NUMBER(y, AT(odometry.position.y))
static const struct frob_field position_fields[] = { { "x", &x }, { "y", &y } };
PRODUCT(position, position_fields)
NUMBER(heading, AT(odometry.heading))
static const struct frob_field pose_fields[] = { { "position", &position },
                                                 { "heading", &heading } };
PRODUCT(pose, pose_fields)

NUMBER(left_wheel, AT(leftWheel))
NUMBER(right_wheel, AT(rightWheel))
TRUTH(front_bumper, AT(frontBumper))
TRUTH(rear_bumper, AT(rearBumper))
TRUTH(left_stall, AT(leftStall))
TRUTH(right_stall, AT(rightStall))
NUMBER(battery, AT(battery))
TRUTH(motors_on, AT(motorsOn))
static const struct frob_field input_fields[] = {
    { "odometry", &pose },        { "leftWheel", &left_wheel },     { "rightWheel", &right_wheel },
    { "sonar", &sonar },          { "frontBumper", &front_bumper }, { "rearBumper", &rear_bumper },
    { "leftStall", &left_stall }, { "rightStall", &right_stall },   { "battery", &battery },
    { "motorsOn", &motors_on },
};
PRODUCT(pioneer_input, input_fields)

NUMBER(forward, offsetof(struct frob_pioneer_output, forward))
NUMBER(turn, offsetof(struct frob_pioneer_output, turn))
static const struct frob_field output_fields[] = { { "forward", &forward }, { "turn", &turn } };
PRODUCT(pioneer_output, output_fields)

const struct frob_program frob_program = {
    .abi = FROB_PROGRAM_ABI,
    .name = "wall_follower",
    .robot = "pioneer",
    .state_size = sizeof(struct state),
    .input_size = sizeof(struct frob_pioneer_input),
    .output_size = sizeof(struct frob_pioneer_output),
    .input = &pioneer_input,
    .output = &pioneer_output,
    .reset = reset,
    .step = step,
    .is_valid = is_valid,
    .arithmetic = frob_arithmetic_faults,
};
