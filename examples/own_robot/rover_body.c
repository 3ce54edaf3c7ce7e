/* rover_body.c -- a Rover's body, for the simulator. Measures are those of
 * Rover.frob; what a scale and a tape do not tell is an estimate. */
#include <frob/body.h>

#include "rover.h"

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

/* C++ would not let the table be seen from outside without this. */
extern const struct frob_body frob_rover_body;

const struct frob_body frob_rover_body = {
    "rover",
    "Rover",
    sizeof(struct frob_rover_input),
    sizeof(struct frob_rover_output),
    2.5,
    RADIUS_M,
    0.0325,
    SEPARATION_M,
    8.0,
    1.0 / 8000.0,
    12.3,
    SPEED_M_S,
    2.0 * SPEED_M_S / SEPARATION_M,
    0.8,
    8.0,
    rangers,
    RANGERS,
    15.0 * DEGREES,
    0.02,
    3.0,
    0.01,
    0.02,
    0,
    2,
    4,
    sense,
    command,
    NULL, /* nothing looks at the floor, and it has no photocells */
    0,
    0.0,
    NULL,
    0,
};
