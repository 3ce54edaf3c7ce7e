/* scout/command.h -- the commands that the driver sends to a Scout.
 *
 * The units of the protocol are 0.1 inch (2.54 mm) and 0.1 inch per second. A Scout uses the first
 * two of a command's three axes; the third is 0. Source: Nomadics' Ndirect 2.6.13. */
#ifndef FROB_SCOUT_COMMAND_H
#define FROB_SCOUT_COMMAND_H

#include "drivers/scout/packet.h"
#include "drivers/steps.h"

#define FROB_SCOUT_UNIT_M 0.00254 /* 0.1 inch */
#define FROB_SCOUT_MAX_M_S 1.0    /* maximum wheel speed; 393 units in CARMEN's scoutlib */

#ifdef __cplusplus
extern "C" {
#endif

enum {
    FROB_SCOUT_SONARS = 16,
    /* Sonar rates are multiples of this many milliseconds. */
    FROB_SCOUT_SONAR_UNIT_MS = 4
};

/* A command without data: GS, ST, LP, ZR, GET_... */
struct frob_scout_packet frob_scout_plain(enum frob_scout_type type);

/* AC: acceleration of both wheels, 0.1 inch/s^2. */
struct frob_scout_packet frob_scout_acceleration(unsigned both);

/* Range and resolution of VM: 0.1 inch/s for each wheel. */
static inline struct frob_wire frob_scout_wire(double separation_m)
{
    struct frob_wire wire = { true,
                              { FROB_SCOUT_UNIT_M, FROB_SCOUT_UNIT_M },
                              { FROB_SCOUT_MAX_M_S, FROB_SCOUT_MAX_M_S },
                              separation_m };
    return wire;
}

/* VM: velocities of the first and second axis, 0.1 inch/s. */
struct frob_scout_packet frob_scout_velocities(long first, long second);

/* CONF_SN: fires one sonar every rate * 4 ms, in the order that programs for the Scout usually use,
 * front first: 0 2 15 1 14 3 13 4 12 5 11 6 10 7 9 8. */
struct frob_scout_packet frob_scout_sonars_on(unsigned rate);

/* CONF_SN with an empty firing order. */
struct frob_scout_packet frob_scout_sonars_off(void);

/* CONF_TM: makes the robot stop after this many seconds without a command. 0 means never. */
struct frob_scout_packet frob_scout_watchdog(unsigned seconds);

#ifdef __cplusplus
}
#endif
#endif
