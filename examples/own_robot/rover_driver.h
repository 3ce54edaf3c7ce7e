/* rover_driver.h -- the driver of a Rover on a serial line.
 *
 * Only one command is in transit at a time. A speed is sent as soon as the answer to the
 * previous command has arrived; in between, the driver queries the encoders and the rangers in
 * turn, and the battery occasionally. Answers do not say which command they belong to. If an
 * answer is late or invalid, the driver sends `b` and drops everything up to the answer 57600,
 * which no other command produces.
 *
 * Only `m` resets the board's watchdog, and the driver sends `m` only for commands from the host:
 * if the host stops commanding the robot, the board stops it. */
#ifndef ROVER_DRIVER_H
#define ROVER_DRIVER_H

#include "drivers/driver.h"
#include "drivers/steps.h"
#include "rover_odometry.h"
#include "rover_wire.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Its input and output structs are those of "rover.h". */
extern const struct frob_driver frob_rover_driver;

/* Settings, in the order in which the driver's table lists them. */
enum rover_setting {
    ROVER_BAUD,
    ROVER_WATCHDOG_MS,
    ROVER_COUNTS_PER_M,
    ROVER_SEPARATION_M,
    ROVER_PATIENCE_S,
    ROVER_SETTING_COUNT
};

/* The answer that the driver is waiting for. */
enum rover_awaited {
    ROVER_NOTHING,
    ROVER_SYNC, /* 57600, the answer to `b`; anything else is dropped */
    ROVER_SPEED,
    ROVER_COUNTS,
    ROVER_ECHO,
    ROVER_BATTERY,
    ROVER_WATCHDOG
};

struct rover {
    const double *settings;
    struct frob_serial serial;
    struct frob_clock clock;
    enum rover_awaited awaited;
    bool guarded;                    /* whether the watchdog's timeout has been set, or is fixed */
    int64_t sent_ns;                 /* time of the last command sent */
    int64_t heard_ns;                /* time of the last answer or, before the first one, of the
                                      * start */
    int64_t sensed_ns;               /* time of the last accepted counts */
    bool speed_waits;                /* whether this speed has yet to be sent: */
    double forward_m_s, turn_rad_s;  /* this speed */
    struct frob_wire_numbers speeds; /* the wheels' speeds as last sent, in counts per 1/30 s */
    unsigned turn;                   /* which sensor to query next */
    unsigned asked;                  /* the ranger that is being queried */
    bool fresh[ROVER_SONARS];        /* new echoes that the program has not received yet */
    double echo_m[ROVER_SONARS];
    double battery_v;
    struct rover_receiver receiver;
    struct rover_odometry odometry;
};

#ifdef __cplusplus
}
#endif
#endif
