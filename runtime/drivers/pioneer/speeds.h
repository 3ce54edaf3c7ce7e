/* pioneer/speeds.h -- range and resolution of the speed commands: VEL in mm/s and RVEL in deg/s,
 * or VEL2 with the wheels' speeds, in units of the model's divisor. */
#ifndef FROB_DRIVERS_PIONEER_SPEEDS_H
#define FROB_DRIVERS_PIONEER_SPEEDS_H

#include "drivers/steps.h"

#ifdef __cplusplus
extern "C" {
#endif

#define FROB_PIONEER_DEGREE 0.017453292519943295 /* rad */

/* Default limits. */
#define FROB_PIONEER_MOST_M_S 1.2
#define FROB_PIONEER_MOST_RAD_S 5.2359877559829888 /* 300 deg/s */

/* Describes VEL and RVEL, with these limits. */
static inline struct frob_wire frob_pioneer_wire(double most_m_s, double most_rad_s)
{
    struct frob_wire wire = { false, { 1e-3, FROB_PIONEER_DEGREE }, { most_m_s, most_rad_s }, 0.0 };
    return wire;
}

/* Describes VEL2, whose numbers range from -127 to 127, in units of `divisor_mm_s`. `difference` is
 * in 1/mm: omega = difference (v_right - v_left) / 2. */
static inline struct frob_wire frob_pioneer_wheel_wire(double divisor_mm_s, double difference)
{
    double unit = divisor_mm_s * 1e-3;
    struct frob_wire wire = { true, { unit, unit }, { 127 * unit, 127 * unit }, 2e-3 / difference };
    return wire;
}

#ifdef __cplusplus
}
#endif
#endif
