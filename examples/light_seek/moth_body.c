/* moth_body.c -- a Moth's body, for the simulator. Its dimensions are those of Moth.frob; no
 * such robot has been built. */
#include <frob/body.h>

#include "moth.h"

#include <math.h>

#define DEGREES (3.14159265358979323846 / 180.0)
#define RADIUS_M 0.06
#define SEPARATION_M 0.09
#define SPEED_M_S 0.3

enum { RANGERS = 3, SIDES = 2 };

/* The range sensors point 50 degrees to each side, and straight ahead. */
static const struct frob_seat rangers[RANGERS] = {
    { 0.642787609686539 * RADIUS_M, 0.766044443118978 * RADIUS_M, 50.0 * DEGREES },
    { RADIUS_M, 0.0, 0.0 },
    { 0.642787609686539 * RADIUS_M, -0.766044443118978 * RADIUS_M, -50.0 * DEGREES },
};

/* The photocells are on top, so that the body does not shade them. */
static const struct frob_seat photocells[SIDES] = {
    { 0.04, 0.02, 45.0 * DEGREES },
    { 0.04, -0.02, -45.0 * DEGREES },
};

/* The floor sensors are 19 mm apart, which is the width of ordinary tape. */
static const struct frob_spot floor_sensors[SIDES] = {
    { 0.05, 0.0095 },
    { 0.05, -0.0095 },
};

static void sense(const struct frob_senses *senses, void *into)
{
    struct frob_moth_input *input = (struct frob_moth_input *)into;
    input->odometry.position.x = senses->x_m;
    input->odometry.position.y = senses->y_m;
    input->odometry.heading = senses->heading_rad;
    input->leftWheel = senses->left_m_s;
    input->rightWheel = senses->right_m_s;
    for (int i = 0; i < RANGERS; i++) {
        if (!isnan(senses->echoes_m[i])) {
            input->ranger[i].tag = FROB_EVENT_FLOAT_EVENT;
            input->ranger[i].f0 = senses->echoes_m[i];
        }
    }
    for (int i = 0; i < SIDES; i++) {
        input->light[i] = senses->light_lux[i];
        input->floor[i] = senses->floor[i];
    }
}

static void command(const void *from, double *forward_m_s, double *turn_rad_s)
{
    const struct frob_moth_output *output = (const struct frob_moth_output *)from;
    *forward_m_s = output->forward;
    *turn_rad_s = output->turn;
}

/* In C++, other files can see a const table only with this declaration. */
extern const struct frob_body frob_moth_body;

const struct frob_body frob_moth_body = {
    .robot = "moth",
    .title = "Moth",
    .input_size = sizeof(struct frob_moth_input),
    .output_size = sizeof(struct frob_moth_output),
    .mass_kg = 0.4,
    .radius_m = RADIUS_M,
    .wheel_radius_m = 0.016,
    .wheel_separation_m = SEPARATION_M,
    .wheel_force_n = 1.5,
    .count_m = 0.0001,
    .battery_v = 4.8,
    .speed_m_s = SPEED_M_S,
    .turn_rad_s = 2.0 * SPEED_M_S / SEPARATION_M,
    .acceleration_m_s2 = 1.0,
    .turn_acceleration_rad_s2 = 20.0,
    .rangers = rangers,
    .ranger_count = RANGERS,
    .half_angle_rad = 10.0 * DEGREES,
    .nearest_m = 0.02,
    .farthest_m = 1.5,
    .resolution_m = 0.001,
    .period_s = 0.02,
    .left = 0,
    .ahead = 1,
    .right = 2,
    .sense = sense,
    .command = command,
    .floor_sensors = floor_sensors,
    .floor_sensor_count = SIDES,
    .floor_spot_m = 0.005,
    .photocells = photocells,
    .photocell_count = SIDES,
};
