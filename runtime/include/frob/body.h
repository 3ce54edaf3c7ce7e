/* frob/body.h -- the simulated body of a robot of the user's own.
 *
 * A body is a constant table in a C file that is given with `--with`: the
 * robot `rover`, whose module is Rover.frob, has
 *
 *   const struct frob_body frob_rover_body = { .robot = "rover", … };
 *
 * With its members named (C, and C++ from C++20 on) the table stays right when a later
 * version has more of them: what is left out is zero. Without names C compilers warn
 * of what is left out, and a member in between would shift the others.
 *
 * Bodies are round, on two wheels, with rangers that fire one after the other, and
 * perhaps with sensors that look down at the floor or see the light of lamps.
 * The robot's frame: origin midway between the wheels and in the middle of the
 * body, x forward, y left; angles in radians, counter-clockwise. */
#ifndef FROB_BODY_H
#define FROB_BODY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Where a ranger sits and looks. */
struct frob_seat {
    double x_m, y_m, heading_rad;
};

/* Where a sensor looks straight down. */
struct frob_spot {
    double x_m, y_m;
};

/* What the body senses at an instant. */
struct frob_senses {
    int64_t time_ns;              /* since the start */
    double x_m, y_m, heading_rad; /* by odometry, from where it started */
    double left_m_s, right_m_s;   /* measured speeds of the wheels */
    bool left_stalled, right_stalled;
    bool pressed_ahead, pressed_behind; /* something touches the body before or behind its middle */
    double battery_v;
    const double
        *echoes_m; /* of each ranger: NaN, or an echo that has come since the last instant */
    const double
        *floor; /* of each floor sensor: the share of its light that comes back, 0 (black, or no
                               floor) to 1 (white), with noise */
    const double *light_lux; /* of each photocell: illuminance, cd/m^2 */
};

struct frob_body {
    const char *robot;              /* "rover", as in struct frob_program */
    const char *title;              /* "Rover", for pictures */
    size_t input_size, output_size; /* of the robot's structs */
    double mass_kg;
    double radius_m;
    double wheel_radius_m;
    double wheel_separation_m;
    double wheel_force_n; /* that a motor can bring to the floor */
    double count_m;       /* way of a wheel that an encoder's count is; 0: as if continuous */
    double battery_v;     /* at the start, where the world file does not say */

    /* What the firmware limits commands to, where the world file does not say. */
    double speed_m_s, turn_rad_s, acceleration_m_s2, turn_acceleration_rad_s2;

    const struct frob_seat *rangers; /* at least one, in the order in which they fire */
    size_t ranger_count;
    double half_angle_rad;        /* of the cone of each */
    double nearest_m, farthest_m; /* what is nearer reads so, what is farther gives no echo */
    double resolution_m;          /* 0: none */
    double period_s;              /* from one ranger to the next */
    size_t left, ahead, right;    /* the rangers that look there most, for pictures */

    /* Fills in the robot's input struct, which is all zero before. */
    void (*sense)(const struct frob_senses *senses, void *input);

    /* What the robot's output struct asks for; values out of range are limited. */
    void (*command)(const void *output, double *forward_m_s, double *turn_rad_s);

    /* What many bodies do not have: left out, there is none. */
    const struct frob_spot *floor_sensors;
    size_t floor_sensor_count;
    double floor_spot_m; /* the width of what each sees, at least a millimetre */
    const struct frob_seat *photocells;
    size_t photocell_count;
};

#ifdef __cplusplus
}
#endif
#endif
