/* frob/body.h -- the simulated body of a user-defined robot.
 *
 * A body is a constant table in a C file passed with `--with`. For the robot `rover`, whose module
 * is Rover.frob, it is
 *
 *   const struct frob_body frob_rover_body = { .robot = "rover", … };
 *
 * Use designated initializers (in C, or in C++ since C++20). With these, the table stays correct
 * when a later version adds members, because omitted members are zero. If members are initialized
 * by position, C compilers warn about omitted members, and a member added in the middle shifts the
 * rest.
 *
 * A body is round and has two wheels and rangers that fire one after the other. It may also have
 * sensors that look down at the floor, and photocells that measure the light of lamps. The robot's
 * frame: the origin is midway between the wheels, at the centre of the body; x points forward, y
 * left; angles are in radians, counter-clockwise. */
#ifndef FROB_BODY_H
#define FROB_BODY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Position and direction of a ranger or photocell. */
struct frob_seat {
    double x_m, y_m, heading_rad;
};

/* Position of a sensor that looks straight down. */
struct frob_spot {
    double x_m, y_m;
};

/* The body's readings at one instant. */
struct frob_senses {
    int64_t time_ns;              /* since the start of the run */
    double x_m, y_m, heading_rad; /* odometry; the origin is the starting pose */
    double left_m_s, right_m_s;   /* measured wheel speeds */
    bool left_stalled, right_stalled;
    /* Whether something touches the front or the rear half of the body. */
    bool pressed_ahead, pressed_behind;
    double battery_v;
    /* One reading for each ranger: the range of an echo that has arrived since the last instant, or
     * NaN. */
    const double *echoes_m;
    /* One reading for each floor sensor: the fraction of the sensor's light that the floor
     * reflects, from 0 (black, or no floor) to 1 (white), with noise. */
    const double *floor;
    const double *light_lux; /* one reading for each photocell: the illuminance */
};

struct frob_body {
    const char *robot;              /* "rover", as in struct frob_program */
    const char *title;              /* "Rover", shown in pictures */
    size_t input_size, output_size; /* sizes of the robot's structs */
    double mass_kg;
    double radius_m;
    double wheel_radius_m;
    double wheel_separation_m;
    double wheel_force_n; /* maximum force that a wheel can exert on the floor */
    double count_m;       /* distance per encoder count; 0 for a continuous reading */
    double battery_v;     /* initial voltage, unless the world file sets it */

    /* Limits that the firmware applies to commands, unless the world file sets them. */
    double speed_m_s, turn_rad_s, acceleration_m_s2, turn_acceleration_rad_s2;

    const struct frob_seat *rangers; /* the rangers, at least one, in firing order */
    size_t ranger_count;
    double half_angle_rad; /* half the opening angle of each ranger's beam */
    /* Obstacles nearer than `nearest_m` read as `nearest_m`; those beyond `farthest_m` return no
     * echo. */
    double nearest_m, farthest_m;
    double resolution_m; /* 0: continuous */
    double period_s;     /* time between the firings of successive rangers */
    /* Indices of the rangers that point most nearly to the left, ahead and to the right; for
     * pictures. */
    size_t left, ahead, right;

    /* Fills in the robot's input struct, which is all zero before the call. */
    void (*sense)(const struct frob_senses *senses, void *input);

    /* Reads the commanded speeds from the robot's output struct. The simulator limits values that
     * are out of range. */
    void (*command)(const void *output, double *forward_m_s, double *turn_rad_s);

    /* Optional sensors. The body has none if these members are omitted. */
    const struct frob_spot *floor_sensors;
    size_t floor_sensor_count;
    double floor_spot_m; /* diameter of the spot that each sensor sees, at least 0.001 */
    const struct frob_seat *photocells;
    size_t photocell_count;

    /* Resolution of the speeds in the robot's protocol, for a robot whose driver rounds with
     * drivers/steps.h; the simulator then rounds in the same way. Set either `wheel_step_m_s`, or
     * both `speed_step_m_s` and `turn_step_rad_s`. */
    double wheel_step_m_s;
    double speed_step_m_s, turn_step_rad_s;
};

#ifdef __cplusplus
}
#endif
#endif
