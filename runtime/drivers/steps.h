/* drivers/steps.h -- rounds speeds to the whole steps of a robot's protocol.
 *
 * A protocol sends a speed as an integer multiple of a unit: a Pioneer receives mm/s and deg/s, a
 * Scout tenths of an inch per second. Rounding each command separately would lose speeds below half
 * a step, however long they are commanded. So each command carries over the rounding error of the
 * previous ones (a first-order sigma-delta modulator), and the mean of the sent numbers is the
 * wanted speed.
 *
 * The number sent is always one of the two whole numbers next to the wanted one. The accumulated
 * error is dropped if the wanted number is zero or is clamped to the limit, and after a pause; a
 * driver also drops it (all zero) when it stops the robot or connects. So the accumulated error
 * never moves a robot that should be at rest.
 *
 * Drivers and the simulator both use this header, so that a program drives a real robot and a
 * simulated one along the same path. It has no casts, because C++ compiles it too. */
#ifndef FROB_DRIVERS_STEPS_H
#define FROB_DRIVERS_STEPS_H

#include <math.h>
#include <stdbool.h>

#include "drivers/wheels.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The time without a command, in seconds, after which the accumulated error is dropped. */
#define FROB_STEPS_PAUSE_S 0.5

/* State of one number of the protocol. All zero: the robot is at rest, with no accumulated
 * error. */
struct frob_steps {
    double sent;    /* the current number, sent at `since_s`, in whole steps */
    double missing; /* the commanded number minus `sent` */
    double owed;    /* error accumulated before `since_s`, in steps times seconds */
    double since_s;
};

/* Computes the number to send now, and updates the accumulated error. `most`, which need not be a
 * whole number, is the maximum number of steps in either direction. */
static inline struct frob_steps frob_steps_next(const struct frob_steps *before, double wanted,
                                                double most, double now_s)
{
    double passed_s = now_s - before->since_s, top = floor(most + 1e-6), share = 0.0;
    struct frob_steps next = { 0.0, 0.0, 0.0, now_s };
    if (wanted == 0.0)
        return next;
    if (fabs(wanted) >= top) {
        next.sent = wanted > 0.0 ? top : -top;
        return next;
    }
    if (passed_s <= FROB_STEPS_PAUSE_S)
        next.owed = before->owed + before->missing * passed_s;
    /* Spreads the correction over a period as long as the last command lasted. */
    if (next.owed != 0.0 && passed_s > 0.0)
        share = next.owed / passed_s;
    next.sent = fmin(fmax(round(wanted + share), floor(wanted)), ceil(wanted));
    next.missing = wanted - next.sent;
    return next;
}

/* Range and resolution of the two numbers in a robot's speed command. */
struct frob_wire {
    bool wheels;         /* true: speeds of the left and right wheels; false: forward speed and turn
                          * rate */
    double step[2];      /* unit of each number: m/s, or rad/s for a turn rate */
    double most[2];      /* maximum of each number, in the same unit */
    double separation_m; /* distance between the wheels */
};

struct frob_wire_numbers {
    struct frob_steps number[2];
};

/* Computes the numbers for a forward speed and a turn rate. If one wheel would be too fast, both
 * are slowed down. */
static inline struct frob_wire_numbers frob_wire_next(const struct frob_wire *wire,
                                                      const struct frob_wire_numbers *before,
                                                      double forward_m_s, double turn_rad_s,
                                                      double now_s)
{
    double speed[2] = { forward_m_s, turn_rad_s };
    struct frob_wire_numbers next;
    if (wire->wheels) {
        struct frob_wheels wheels =
            frob_wheels_of(forward_m_s, turn_rad_s, wire->separation_m, wire->most[0]);
        speed[0] = wheels.left;
        speed[1] = wheels.right;
    }
    for (int i = 0; i < 2; i++)
        next.number[i] = frob_steps_next(&before->number[i], speed[i] / wire->step[i],
                                         wire->most[i] / wire->step[i], now_s);
    return next;
}

/* Converts the numbers back to a forward speed, m/s, and a turn rate, rad/s. */
static inline double frob_wire_forward(const struct frob_wire *wire,
                                       const struct frob_wire_numbers *numbers)
{
    double first = numbers->number[0].sent * wire->step[0];
    return wire->wheels ? 0.5 * (first + numbers->number[1].sent * wire->step[1]) : first;
}

static inline double frob_wire_turn(const struct frob_wire *wire,
                                    const struct frob_wire_numbers *numbers)
{
    double second = numbers->number[1].sent * wire->step[1];
    return wire->wheels ? (second - numbers->number[0].sent * wire->step[0]) / wire->separation_m
                        : second;
}

#ifdef __cplusplus
}
#endif
#endif
