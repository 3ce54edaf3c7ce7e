/* create/create.h -- an iRobot Create 2 on a serial line.
 *
 * The driver puts the robot into Safe mode (or Full mode) and requests a stream of frames. Leaving
 * that mode is a fault: the robot leaves Safe mode at a cliff, a wheel drop or a charger. The
 * driver does not restore the mode until the host restarts the driver.
 *
 * The robot has NO watchdog: it follows the last command forever. The host must stop it; if the
 * cable is pulled, nothing can.
 *
 * Commands have neither a frame nor a checksum. After a lost byte the robot reads the first byte of
 * the next command as data, and may stay out of step for a long time. Therefore the driver sends a
 * few zeros before each drive command: they complete a truncated command, and zero itself is not an
 * opcode. Noise can start a command of up to 513 bytes (a song), during which the robot ignores all
 * commands. Therefore the driver sends 513 zeros when it connects, and when it stops a robot from
 * which it does not receive anything.
 *
 * The driver requests only packets that some field of the input needs, so that frames stay short.
 * It omits packet 45, which has a bit for each light bumper, because the signals in
 * packets 46 to 51 contain more information. It also omits packet 23, the battery's current,
 * because packet 21 reports whether the battery is charging, and packets 25 and 26 report its
 * charge and capacity.
 *
 * The settings cover the values on which sources disagree. */
#ifndef FROB_DRIVERS_CREATE_CREATE_H
#define FROB_DRIVERS_CREATE_CREATE_H

#include "drivers/create/odometry.h"
#include "drivers/create/stream.h"
#include "drivers/driver.h"
#include "drivers/steps.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The driver. Its input and output are those of <frob/create.h>. */
extern const struct frob_driver frob_create_driver;

/* Settings, in the order in which the driver's table lists them. */
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

/* Stages of connecting. The command of the current stage has been sent. */
enum frob_create_step {
    FROB_CREATE_RESTING, /* no command has been sent yet */
    FROB_CREATE_STARTED,
    FROB_CREATE_IN_MODE,
    FROB_CREATE_STREAMING,
    FROB_CREATE_CONNECTED /* a frame has arrived, and the mode is right */
};

struct frob_create {
    const double *settings;
    struct frob_serial serial;
    struct frob_clock clock;
    enum frob_create_step step;
    unsigned attempts;               /* number of attempts to connect */
    int64_t step_ns;                 /* time at which the step's command was sent */
    int64_t heard_ns;                /* time at which the last frame arrived or, before that, at
                                      * which the connection began */
    int64_t byte_ns;                 /* when the last byte arrived */
    int64_t sensed_ns;               /* time at which the last frame arrived; INT64_MIN if there was
                                      * none */
    int64_t asked_ns;                /* when the stream was requested */
    unsigned out_of_mode;            /* number of consecutive frames that report a different mode */
    bool refused;                    /* whether the robot has left driving mode, or has failed to
                                      * enter it */
    struct frob_wire_numbers speeds; /* the wheel speeds that were sent last */
    uint8_t lights[4];               /* the LEDS command that was sent last */
    int64_t lights_ns;               /* time at which this LEDS command was sent */
    struct frob_create_stream stream;
    struct frob_create_sensors sensors;
    struct frob_create_odometry odometry;
};

#ifdef __cplusplus
}
#endif
#endif
