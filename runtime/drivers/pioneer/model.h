/* model.h -- the factors that convert the units of the protocol, for each Pioneer model.
 *
 * Source: the parameter files of ARIA (`*.p`) and Player's robot_params.cc, which agree on
 * these values. */
#ifndef FROB_DRIVERS_PIONEER_MODEL_H
#define FROB_DRIVERS_PIONEER_MODEL_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

struct frob_p2os_model {
    const char *subclass; /* the name that the robot reports, in lower case */
    double angle;         /* radians per unit of THPOS */
    double distance;      /* mm per unit of XPOS and YPOS */
    double speed;         /* mm/s per unit of a wheel's speed */
    double range;         /* mm per unit of a sonar's range */
    double difference;    /* omega = difference (v_right - v_left) / 2; 1/mm */
    double vel2_divisor;  /* mm/s per unit of VEL2 */
    double most_mm_s;     /* maximum speed that the model accepts */
    double most_deg_s;
    uint32_t switch_rate; /* bit rate to switch the line to; 0: do not switch */
    uint8_t sonars;
    uint8_t has_flags; /* SIPs report whether the motors are on (AROS and ARCOS) */
};

/* Returns the model with this subclass, ignoring case, or NULL if there is none. */
const struct frob_p2os_model *frob_p2os_find_model(const char *subclass);

/* Returns all models, for tests. */
const struct frob_p2os_model *frob_p2os_models(size_t *count);

#ifdef __cplusplus
}
#endif
#endif
