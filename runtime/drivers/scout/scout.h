/* scout/scout.h -- a Nomadic Scout behind a serial line.
 *
 * One command is on its way at a time, and each is answered by the robot's
 * state. A velocity waits for the answer to what went before; between
 * velocities the state is asked for. The robot's own watchdog (CONF_TM) is set
 * at the start. Any command feeds it, the question for the state too: so a
 * robot that was told to move is asked only while the host goes on telling it.
 *
 * Noise can begin a packet of up to 259 bytes, whose end the robot awaits before
 * it hears anything else. So a stop that comes because the robot is not heard
 * is sent again behind as many zeros.
 *
 * What sources disagree on is in the table of settings. */
#ifndef FROB_DRIVERS_SCOUT_SCOUT_H
#define FROB_DRIVERS_SCOUT_SCOUT_H

#include "drivers/driver.h"
#include "drivers/scout/odometry.h"
#include "drivers/scout/packet.h"
#include "drivers/scout/sonar.h"
#include "drivers/scout/state.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Its input and output are those of <frob/scout.h>. */
extern const struct frob_driver frob_scout_driver;

/* Settings, in the order of the driver's table. */
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

/* The steps of connecting: each is a command that must be answered. */
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
    unsigned refusals;    /* of velocities, one after the other */
    uint8_t awaited;      /* the type of answer that is due; 0: none */
    int64_t sent_ns;      /* the command that went out last */
    int64_t heard_ns;     /* the answer that came last, or the start */
    int64_t byte_ns;      /* the last byte */
    int64_t sensed_ns;    /* the state that came last */
    int64_t commanded_ns; /* the velocity, or the stop, that the host gave last */
    bool velocity_waits;  /* a velocity is to be sent */
    long first, second;   /* which, 0.1 inch/s */
    struct frob_scout_receiver receiver;
    struct frob_scout_state state;
    struct frob_scout_odometry odometry;
    struct frob_scout_sonar sonar;
};

#ifdef __cplusplus
}
#endif
#endif
