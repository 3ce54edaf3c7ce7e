/* scout/scout.h -- a Nomadic Scout on a serial line.
 *
 * At most one command is pending at a time, and the robot answers each with its state. A velocity
 * command waits for the answer to the command before it; between velocity commands the driver
 * requests the state. When it connects, the driver sets the robot's own watchdog (CONF_TM). Any
 * command feeds this watchdog, including a request for the state. Therefore, while the robot moves,
 * the driver requests the state only as long as the host keeps sending commands.
 *
 * Noise can start a packet of up to 259 bytes, and the robot ignores commands until the packet
 * ends. Therefore, if the robot does not answer, the driver stops it by sending the stop command,
 * that many zeros, and the stop command again.
 *
 * The settings cover the values on which sources disagree. */
#ifndef FROB_DRIVERS_SCOUT_SCOUT_H
#define FROB_DRIVERS_SCOUT_SCOUT_H

#include "drivers/driver.h"
#include "drivers/scout/odometry.h"
#include "drivers/scout/packet.h"
#include "drivers/scout/sonar.h"
#include "drivers/scout/state.h"
#include "drivers/steps.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The driver. <frob/scout.h> defines its input and output. */
extern const struct frob_driver frob_scout_driver;

/* Settings, in the order in which the driver's table lists them. */
enum frob_scout_setting {
    FROB_SCOUT_BAUD,
    FROB_SCOUT_WATCHDOG_S,
    FROB_SCOUT_LEFT_FIRST,
    FROB_SCOUT_SEPARATION_M,
    FROB_SCOUT_ACCELERATION_M_S2,
    FROB_SCOUT_SONAR_MS,
    FROB_SCOUT_POLL_S,
    FROB_SCOUT_PATIENCE_S,
    FROB_SCOUT_FLUSH,
    FROB_SCOUT_SETTING_COUNT
};

/* Stages of connecting. The robot must answer the command of each stage. */
enum frob_scout_step {
    FROB_SCOUT_STOPPING,
    FROB_SCOUT_WATCHDOG,
    FROB_SCOUT_ACCELERATION,
    FROB_SCOUT_SONARS_ON,
    FROB_SCOUT_CONNECTED
};

struct frob_scout {
    const double *settings;
    struct frob_serial serial;
    struct frob_clock clock;
    enum frob_scout_step step;
    bool refused;
    unsigned refusals;               /* number of consecutive velocity commands that the robot
                                      * refused */
    uint8_t awaited;                 /* type of the pending answer; 0 if there is none */
    int64_t sent_ns;                 /* time at which the last command was sent */
    int64_t heard_ns;                /* time at which the last answer arrived or, before that, at
                                      * which the connection began */
    int64_t byte_ns;                 /* when the last byte arrived */
    int64_t sensed_ns;               /* when the last state arrived */
    int64_t commanded_ns;            /* time at which the host last commanded a velocity or a
                                      * stop */
    bool velocity_waits;             /* whether a velocity must be sent */
    double forward_m_s, turn_rad_s;  /* that velocity */
    struct frob_wire_numbers speeds; /* the wheel speeds that were sent last */
    struct frob_scout_receiver receiver;
    struct frob_scout_state state;
    struct frob_scout_odometry odometry;
    struct frob_scout_sonar sonar;
};

#ifdef __cplusplus
}
#endif
#endif
