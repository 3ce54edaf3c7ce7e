/* pioneer.h -- the driver of Pioneer robots: ActivMedia's and MobileRobots'
 * Pioneer 1, 2 and 3, PeopleBot and AmigoBot, on PSOS, P2OS, AROS or ARCOS.
 *
 * Units here are metres, radians, seconds and volts; the wire's are those of
 * packet.h and sip.h, and never leave this folder.
 *
 * Connecting finds the line's rate, shakes hands (SYNC0 to SYNC2), looks the
 * model up, sets both speeds to zero, and only then turns the motors on. It listens
 * first: a Pioneer whose watchdog has stopped it takes up its old speed again at the
 * next command, and one in a session takes SYNC0 for PULSE. Such a one sends packets,
 * and is told zeros and CLOSE. One that is silent is told nothing before SYNC0.
 * The driver sends no PULSE once the robot can be commanded: then only commands
 * feed the robot's watchdog, so that a host that has stopped commanding is noticed
 * by the robot itself. */
#ifndef FROB_DRIVERS_PIONEER_H
#define FROB_DRIVERS_PIONEER_H

#include <stdbool.h>

#include "drivers/driver.h"
#include "drivers/pioneer/model.h"
#include "drivers/pioneer/packet.h"
#include "drivers/pioneer/sip.h"
#include <frob/pioneer.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Settings, in the order of the driver's table. */
enum frob_pioneer_setting {
    FROB_PIONEER_BAUD,
    FROB_PIONEER_SWITCH_BAUD,
    FROB_PIONEER_ANGLE,
    FROB_PIONEER_DISTANCE,
    FROB_PIONEER_SPEED,
    FROB_PIONEER_RANGE,
    FROB_PIONEER_DIFFERENCE,
    FROB_PIONEER_VEL2_DIVISOR,
    FROB_PIONEER_MAX_SPEED,
    FROB_PIONEER_MAX_TURN,
    FROB_PIONEER_WHEELS,
    FROB_PIONEER_NO_ECHO,
    FROB_PIONEER_MOTORS_FLAG,
    FROB_PIONEER_HARD_STOP,
    FROB_PIONEER_SILENCE,
    FROB_PIONEER_INTERVAL,
    FROB_PIONEER_CARRY_ON,
    FROB_PIONEER_SETTING_COUNT
};

enum { FROB_PIONEER_SONARS = 16 };

/* Where connecting has got to. */
enum frob_pioneer_phase {
    FROB_PIONEER_OVERHEARING, /* is the robot in a session already? */
    FROB_PIONEER_SYNC,        /* sync 0, 1 or 2 is sent, its echo awaited */
    FROB_PIONEER_CLOSING,     /* the robot was in a session; its end is awaited */
    FROB_PIONEER_OPENING,     /* the commands that begin a session are being sent */
    FROB_PIONEER_LISTENING,   /* for the first SIP */
    FROB_PIONEER_CONNECTED,
    FROB_PIONEER_SILENT, /* gave up: nobody answers */
    FROB_PIONEER_UNKNOWN /* the robot is of no known model */
};

struct frob_pioneer_sonar {
    double range_m;
    int64_t heard_ns; /* INT64_MIN: never */
    bool fresh;       /* heard since the last input */
};

/* One robot. All zero before the first start; after that the caller leaves it
 * alone, for what was learnt (the rate, where odometry is) helps to reconnect. */
struct frob_pioneer {
    const double *settings;
    struct frob_serial serial;
    struct frob_clock clock;
    struct frob_p2os_receiver receiver;

    enum frob_pioneer_phase phase;
    uint8_t sync;       /* which of the three */
    uint8_t attempt;    /* of what the phase sends */
    uint8_t tried;      /* rates, so far */
    uint8_t step;       /* of opening */
    bool still_open;    /* a SIP came after CLOSE */
    int64_t heard_ns;   /* the last byte */
    bool motors_seen;   /* the motors have been on in this session */
    int64_t until_ns;   /* when the phase loses patience, or sends its next */
    uint32_t rate;      /* of the line now */
    uint32_t good_rate; /* at which a robot has answered; 0: not known */
    uint32_t sync_rate; /* at which it has shaken hands; 0: not known */
    bool switch_failed; /* at the switched rate nothing was heard */
    bool rate_fixed;    /* the line could not change to the rate last tried */

    struct frob_p2os_identity identity;
    struct frob_p2os_model model; /* with the settings that replace its factors */
    struct frob_p2os_robot_config config;
    bool has_config;
    uint8_t config_asked;
    int64_t config_due_ns;
    char description[3 * FROB_P2OS_NAME_ROOM + 16];

    int64_t sensed_ns;
    struct frob_p2os_sip sip; /* the newest */
    bool has_counters;        /* the session has had a SIP */
    uint16_t x, y;            /* its counters */
    double turned_rad;        /* from the counters' axes to the odometry's */
    struct frob_pose odometry;
    struct frob_pioneer_sonar sonar[FROB_PIONEER_SONARS];

    int32_t wanted[2]; /* VEL and RVEL in mm/s and deg/s, or VEL2's left and right */
    int32_t sent[2];
    bool has_wanted;     /* since the last sending */
    bool second_pending; /* RVEL follows VEL after a pause */
    int64_t sent_ns;     /* INT64_MIN: nothing yet */
};

extern const struct frob_driver frob_pioneer_driver;

/* What transducer `i` heard last, and how long ago; false if it never did or
 * nothing was in range. */
bool frob_pioneer_echo(const struct frob_pioneer *device, size_t i, double *range_m, double *age_s);

#ifdef __cplusplus
}
#endif
#endif
