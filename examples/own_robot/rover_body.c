/* rover_body.c -- a Rover's body, for the simulator. Its dimensions are those of Rover.frob;
 * everything that a scale and a tape measure cannot determine is an estimate. */
#include <frob/body.h>

#include "rover.h"
#include "rover_wire.h"

#include <math.h>

#define PI 3.14159265358979323846
#define DEGREES (PI / 180.0)

#define RADIUS_M 0.12
#define DIAGONAL_M (RADIUS_M * 0.70710678118654752)
#define SEPARATION_M 0.19
#define SPEED_M_S 0.5

enum { RANGERS = 5 };

static const struct frob_seat rangers[RANGERS] = {
    { 0.0, RADIUS_M, 90.0 * DEGREES },
    { DIAGONAL_M, DIAGONAL_M, 45.0 * DEGREES },
    { RADIUS_M, 0.0, 0.0 },
    { DIAGONAL_M, -DIAGONAL_M, -45.0 * DEGREES },
    { 0.0, -RADIUS_M, -90.0 * DEGREES },
};

static void sense(const struct frob_senses *senses, void *into)
{
    struct frob_rover_input *input = (struct frob_rover_input *)into;
    input->odometry.position.x = senses->x_m;
    input->odometry.position.y = senses->y_m;
    input->odometry.heading = senses->heading_rad;
    input->leftWheel = senses->left_m_s;
    input->rightWheel = senses->right_m_s;
    for (int i = 0; i < RANGERS; i++) {
        if (!isnan(senses->echoes_m[i])) {
            input->sonar[i].tag = FROB_EVENT_FLOAT_EVENT;
            input->sonar[i].f0 = senses->echoes_m[i];
        }
    }
    input->battery = senses->battery_v;
}

static void command(const void *from, double *forward_m_s, double *turn_rad_s)
{
    const struct frob_rover_output *output = (const struct frob_rover_output *)from;
    *forward_m_s = output->forward;
    *turn_rad_s = output->turn;
}

/* In C++, a const table has internal linkage without this declaration. */
extern const struct frob_body frob_rover_body;

const struct frob_body frob_rover_body = {
    .robot = "rover",
    .title = "Rover",
    .input_size = sizeof(struct frob_rover_input),
    .output_size = sizeof(struct frob_rover_output),
    .mass_kg = 2.5,
    .radius_m = RADIUS_M,
    .wheel_radius_m = 0.0325,
    .wheel_separation_m = SEPARATION_M,
    .wheel_force_n = 8.0,
    .count_m = 1.0 / ROVER_COUNTS_A_METRE,
    .battery_v = 12.3,
    .speed_m_s = SPEED_M_S,
    .turn_rad_s = 2.0 * SPEED_M_S / SEPARATION_M,
    .acceleration_m_s2 = 0.8,
    .turn_acceleration_rad_s2 = 8.0,
    .rangers = rangers,
    .ranger_count = RANGERS,
    .half_angle_rad = 15.0 * DEGREES,
    .nearest_m = 0.02,
    .farthest_m = 3.0,
    .resolution_m = 0.01,
    .period_s = 0.02,
    .left = 0,
    .ahead = 2,
    .right = 4,
    .sense = sense,
    .command = command,
    .wheel_step_m_s = (double)ROVER_LOOPS / ROVER_COUNTS_A_METRE,
};
