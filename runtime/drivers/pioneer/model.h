/* model.h -- the factors of each model of Pioneer: what its counters count.
 *
 * Source: the parameter files of ARIA (`*.p`) and Player's robot_params.cc,
 * which agree on these. */
#ifndef FROB_DRIVERS_PIONEER_MODEL_H
#define FROB_DRIVERS_PIONEER_MODEL_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

struct frob_p2os_model {
    const char *subclass; /* as the robot says, in small letters */
    double angle;         /* rad of one unit of THPOS */
    double distance;      /* mm of one unit of XPOS, YPOS */
    double speed;         /* mm/s of one unit of a wheel's speed */
    double range;         /* mm of one unit of a sonar's range */
    double difference;    /* omega = difference (v_right - v_left) / 2; 1/mm */
    double vel2_divisor;  /* mm/s of one unit of VEL2 */
    double most_mm_s;     /* that the model can be told */
    double most_deg_s;
    uint32_t switch_rate; /* that the line is switched to; 0: it stays */
    uint8_t sonars;
    uint8_t has_flags; /* SIPs tell whether the motors are on (AROS and ARCOS) */
};

/* The model of a subclass, capital letters or not; NULL if none is so called. */
const struct frob_p2os_model *frob_p2os_find_model(const char *subclass);

/* All of them, for tests. */
const struct frob_p2os_model *frob_p2os_models(size_t *count);

#ifdef __cplusplus
}
#endif
#endif
