/* create/create.h -- an iRobot Create 2 behind a serial line.
 *
 * The robot is put into mode Safe (or Full) and asked for a stream of frames.
 * Leaving that mode is a fault: Safe is left at a cliff, a wheel drop or a
 * charger, and is entered again only when the host starts anew.
 *
 * The robot has NO watchdog: it keeps to the last command for ever. Whoever
 * holds the line must stop it; a cable that is pulled cannot be made safe.
 *
 * Commands have neither frame nor checksum. After a lost byte the robot takes
 * the next command's first byte for data, and can go on so for long; so a few
 * zeros go out before each command that drives: they complete what is
 * incomplete, and are no command themselves. Noise can begin a command of up
 * to 513 bytes (a song), during which the robot hears nothing: when it is
 * connected to, or stopped because it is not heard, as many zeros go out.
 *
 * A packet that no field of the input needs is not asked for, so that a frame
 * stays short. So 45, a bit for each light bumper, is not: the signals 46 to 51
 * tell more. Nor is 23, the battery's current: 21 tells whether it charges, 25
 * and 26 how full it is.
 *
 * What sources disagree on is in the table of settings. */
#ifndef FROB_DRIVERS_CREATE_CREATE_H
#define FROB_DRIVERS_CREATE_CREATE_H

#include "drivers/create/odometry.h"
#include "drivers/create/stream.h"
#include "drivers/driver.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Its input and output are those of <frob/create.h>. */
extern const struct frob_driver frob_create_driver;

/* Settings, in the order of the driver's table. */
enum frob_create_setting {
    FROB_CREATE_BAUD,
    FROB_CREATE_IN_FULL,
    FROB_CREATE_HEADER_IN_SUM,
    FROB_CREATE_SEPARATION_M,
    FROB_CREATE_MODE_PAUSE_S,
    FROB_CREATE_PADDING,
    FROB_CREATE_RIGHT_OVERCURRENT,
    FROB_CREATE_LEFT_OVERCURRENT,
    FROB_CREATE_SETTING_COUNT
};

/* The steps of connecting: the command of each has been sent. */
enum frob_create_step {
    FROB_CREATE_RESTING, /* nothing yet */
    FROB_CREATE_STARTED,
    FROB_CREATE_IN_MODE,
    FROB_CREATE_STREAMING,
    FROB_CREATE_CONNECTED /* a frame has come, and the mode is right */
};

struct frob_create {
    const double *settings;
    struct frob_serial serial;
    struct frob_clock clock;
    enum frob_create_step step;
    unsigned attempts;    /* to connect */
    int64_t step_ns;      /* when the step's command was sent */
    int64_t heard_ns;     /* when the last frame came, or the connection began */
    int64_t byte_ns;      /* the last byte */
    int64_t sensed_ns;    /* when the last frame came */
    int64_t asked_ns;     /* when the stream was asked for */
    unsigned out_of_mode; /* frames, one after the other */
    bool refused;         /* the robot is not in a mode in which it drives */
    uint8_t lights[4];    /* the command LEDS that was sent last */
    int64_t lights_ns;    /* and when */
    struct frob_create_stream stream;
    struct frob_create_sensors sensors;
    struct frob_create_odometry odometry;
};

#ifdef __cplusplus
}
#endif
#endif
