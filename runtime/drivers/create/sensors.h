/* create/sensors.h -- sensor packets of the iRobot Create 2's Open Interface.
 *
 * A sensor packet has an id and one or two bytes of data, high byte first; signed numbers are two's
 * complement. Packets arrive in streams (see stream.h) or, without their id, in answer to a query.
 *
 * Sources: libcreate (AutonomyLab), pycreate2, and the manual of the Create 1 where those agree
 * with it. */
#ifndef FROB_CREATE_SENSORS_H
#define FROB_CREATE_SENSORS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum frob_create_packet_id {
    FROB_CREATE_BUMPS_AND_DROPS = 7,
    FROB_CREATE_CLIFF_LEFT = 9,
    FROB_CREATE_CLIFF_FRONT_LEFT = 10,
    FROB_CREATE_CLIFF_FRONT_RIGHT = 11,
    FROB_CREATE_CLIFF_RIGHT = 12,
    FROB_CREATE_VIRTUAL_WALL = 13,
    FROB_CREATE_OVERCURRENT = 14,
    FROB_CREATE_INFRARED = 17,
    FROB_CREATE_BUTTONS = 18,
    FROB_CREATE_CHARGING = 21,
    FROB_CREATE_VOLTAGE = 22,
    FROB_CREATE_CHARGE = 25,
    FROB_CREATE_CAPACITY = 26,
    FROB_CREATE_CLIFF_LEFT_SIGNAL = 28,
    FROB_CREATE_CLIFF_FRONT_LEFT_SIGNAL = 29,
    FROB_CREATE_CLIFF_FRONT_RIGHT_SIGNAL = 30,
    FROB_CREATE_CLIFF_RIGHT_SIGNAL = 31,
    FROB_CREATE_MODE = 35,
    FROB_CREATE_LEFT_COUNTS = 43,
    FROB_CREATE_RIGHT_COUNTS = 44,
    FROB_CREATE_LIGHT_LEFT = 46,
    FROB_CREATE_LIGHT_FRONT_LEFT = 47,
    FROB_CREATE_LIGHT_CENTER_LEFT = 48,
    FROB_CREATE_LIGHT_CENTER_RIGHT = 49,
    FROB_CREATE_LIGHT_FRONT_RIGHT = 50,
    FROB_CREATE_LIGHT_RIGHT = 51
};

/* The modes. In OFF, in PASSIVE and in any mode not listed here, the robot ignores drive commands.
 * At a cliff, a wheel drop or a charger it switches from SAFE to PASSIVE. */
enum frob_create_mode {
    FROB_CREATE_MODE_OFF = 0,
    FROB_CREATE_MODE_PASSIVE = 1,
    FROB_CREATE_MODE_SAFE = 2,
    FROB_CREATE_MODE_FULL = 3
};

/* Six light bumpers and four cliff sensors, from left to right. */
enum { FROB_CREATE_LIGHTS = 6, FROB_CREATE_CLIFFS = 4 };

struct frob_create_sensors {
    bool bump_right, bump_left;
    bool drop_right, drop_left;
    bool cliff[FROB_CREATE_CLIFFS];
    uint16_t cliff_signal[FROB_CREATE_CLIFFS]; /* intensity of the reflected infrared light */
    bool virtual_wall;
    uint8_t overcurrent; /* one bit for each motor */
    uint8_t infrared;    /* character that the sensor on top has received; 0 if there is none */
    uint8_t buttons; /* bit 0 clean, 1 spot, 2 dock, 3 minute, 4 hour, 5 day, 6 schedule, 7 clock */
    uint8_t charging; /* 0 not charging, 1 reconditioning, 2 full, 3 trickle, 4 waiting, 5 fault */
    uint16_t battery_mv;
    uint16_t charge_mah, capacity_mah;
    uint8_t mode;
    uint16_t left_counts, right_counts; /* encoder counts; they wrap around in both directions */
    uint16_t light_signal[FROB_CREATE_LIGHTS];
};

/* Returns the number of data bytes in a packet, 1 or 2; 0 if the id is unknown. All single packets
 * of the Open Interface, 7 to 58, are known, whether or not they have a field above. */
size_t frob_create_packet_size(unsigned id);

/* Reads one packet's data into its field. Returns false and changes nothing if the packet has no
 * field. */
bool frob_create_read_packet(unsigned id, const uint8_t *data, struct frob_create_sensors *sensors);

/* Returns how far a wheel has turned between two readings, in counts. This is the difference modulo
 * 2^16, which is correct if it is below 2^15 (a distance of 14 m). */
int frob_create_count_step(uint16_t before, uint16_t now);

#ifdef __cplusplus
}
#endif
#endif
