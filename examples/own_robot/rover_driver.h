/* rover_driver.h -- a Rover behind a serial line.
 *
 * One command is on its way at a time. A speed goes out as soon as the answer to
 * what went before is there; in between the encoders and the rangers are asked in
 * turn, and the battery now and then. Answers do not say what they answer: after
 * one that is late or no answer at all, `b` is sent, and all is dropped up to
 * its answer, 57600, which no other command has.
 *
 * Only `m` feeds the board's watchdog, and `m` is sent for the host's commands
 * only: a host that has forgotten the robot stops it. */
#ifndef ROVER_DRIVER_H
#define ROVER_DRIVER_H

#include "drivers/driver.h"
#include "rover_odometry.h"
#include "rover_wire.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Its input and output are those of "rover.h". */
extern const struct frob_driver frob_rover_driver;

/* Settings, in the order of the driver's table. */
enum rover_setting {
    ROVER_BAUD,
    ROVER_WATCHDOG_MS,
    ROVER_COUNTS_PER_M,
    ROVER_SEPARATION_M,
    ROVER_PATIENCE_S,
    ROVER_SETTING_COUNT
};

/* What answer is due. */
enum rover_awaited {
    ROVER_NOTHING,
    ROVER_SYNC, /* 57600: anything else is dropped */
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
    bool guarded;             /* the watchdog has been set, or the board has none */
    int64_t sent_ns;          /* the command that went out last */
    int64_t heard_ns;         /* the answer that came last, or the start */
    int64_t sensed_ns;        /* the counts that came last */
    bool speed_waits;         /* a speed is to be sent: */
    int32_t left, right;      /* which, counts in a loop */
    unsigned turn;            /* whose turn it is to be asked */
    unsigned asked;           /* the ranger that is */
    bool fresh[ROVER_SONARS]; /* echoes that no input has shown yet */
    double echo_m[ROVER_SONARS];
    double battery_v;
    struct rover_receiver receiver;
    struct rover_odometry odometry;
};

#ifdef __cplusplus
}
#endif
#endif
