/* scout/state.h -- the state packet, with which a Scout answers a command.
 *
 * The layout follows the order in which Ndirect 2.6.13 reads the packet for models other than the
 * Nomad 200. The bits of the motor status are the ones that two ROS nodes for the Scout use. The
 * three velocity fields are ignored, because sources interpret them in two ways (as wheel speeds,
 * or as forward speed and turn rate); velocities are computed from odometry instead. */
#ifndef FROB_SCOUT_STATE_H
#define FROB_SCOUT_STATE_H

#include "drivers/scout/command.h"
#include "drivers/scout/packet.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Number of data bytes in a state packet. */
enum { FROB_SCOUT_STATE_DATA = 42 };

/* Bits of the motor status. */
enum {
    FROB_SCOUT_LEFT_MOVING = 1 << 0,
    FROB_SCOUT_RIGHT_MOVING = 1 << 1,
    FROB_SCOUT_BATTERY = 3 << 2, /* 0 low, 1 medium, 2 high */
    FROB_SCOUT_PLUGGED_IN = 1 << 4,
    FROB_SCOUT_CHARGING = 1 << 5,
    FROB_SCOUT_EMERGENCY_STOP = 1 << 6
};

struct frob_scout_state {
    uint8_t sonar_in[FROB_SCOUT_SONARS]; /* inches; 255 is the largest reading */
    uint32_t bumpers;                    /* 24 bits; which bit belongs to which bumper is not
                                          * documented */
    int x, y;                            /* 0.1 inch; wraps around */
    int heading;                         /* 0.1 degree, counter-clockwise */
    unsigned motor_status;               /* FROB_SCOUT_... above */
    uint32_t time_ms;                    /* the robot's clock; wraps around */
    double cpu_v, motor_v;               /* volts */
};

/* Returns whether this packet is a state: a reply to any command that moves or configures the
 * robot. */
bool frob_scout_is_state(const struct frob_scout_packet *packet);

/* Reads a state packet (see frob_scout_is_state). */
struct frob_scout_state frob_scout_read_state(const struct frob_scout_packet *packet);

/* Returns the change in a position field from one state to the next, in units of 0.1 inch. The
 * change must be below 41 m.
 *
 * At 83.2 m the field exceeds its 15 bits. It is not documented whether it then continues at the
 * negative end or at zero, so the difference is taken modulo 2^15, which is correct in both cases
 * (but off by one unit of 2.54 mm if the robot does not use -0). */
int frob_scout_position_step(int before, int now);

/* Returns the change in heading from one state to the next, in units of 0.1 degree, between -1799
 * and 1800. It does not matter whether the robot counts from 0 to 3600 or from -1800 to 1800. */
int frob_scout_heading_step(int before, int now);

#ifdef __cplusplus
}
#endif
#endif
