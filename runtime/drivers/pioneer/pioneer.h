/* pioneer.h -- the driver of Pioneer robots: ActivMedia's and MobileRobots' Pioneer 1, 2 and 3,
 * PeopleBot and AmigoBot, running PSOS, P2OS, AROS or ARCOS.
 *
 * Units here are metres, radians, seconds and volts. The units of the protocol, documented in
 * packet.h and sip.h, are used only in this folder.
 *
 * To connect, the driver finds the line's bit rate, performs the handshake (SYNC0 to SYNC2), looks
 * up the model, sets both speeds to zero, and only then turns the motors on. Before the handshake,
 * it listens to the line, because a Pioneer that was stopped by its watchdog resumes its old speed
 * at the next command, and a Pioneer in a session reads SYNC0 as PULSE. If the robot sends packets,
 * it is in a session, so the driver sends it zero speeds and CLOSE. If the robot is silent, the
 * driver sends nothing before SYNC0, or only CLOSE if it has already tried another rate. Once the
 * robot can be commanded, the driver does not send PULSE. Therefore only commands reset the robot's
 * watchdog, and the robot itself detects that a host has stopped sending commands. */
#ifndef FROB_DRIVERS_PIONEER_H
#define FROB_DRIVERS_PIONEER_H

#include <stdbool.h>

#include "drivers/driver.h"
#include "drivers/pioneer/model.h"
#include "drivers/pioneer/packet.h"
#include "drivers/pioneer/sip.h"
#include "drivers/steps.h"
#include <frob/pioneer.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Settings, in the order in which the driver's table lists them. */
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

/* Phase of connecting. */
enum frob_pioneer_phase {
    FROB_PIONEER_OVERHEARING, /* listening for an already open session */
    FROB_PIONEER_SYNC,        /* SYNC 0, 1 or 2 was sent; waiting for its echo */
    FROB_PIONEER_CLOSING,     /* the robot was in a session; waiting for it to end */
    FROB_PIONEER_OPENING,     /* sending the commands that open a session */
    FROB_PIONEER_LISTENING,   /* waiting for the first SIP */
    FROB_PIONEER_CONNECTED,
    FROB_PIONEER_SILENT, /* the driver has given up, because no robot answers */
    FROB_PIONEER_UNKNOWN /* the robot's model is unknown */
};

struct frob_pioneer_sonar {
    double range_m;
    int64_t heard_ns; /* INT64_MIN: never */
    bool fresh;       /* whether the range arrived after the last frob_pioneer_sense */
};

/* The driver's state for one robot. All zero before the first start. After that, the caller must
 * not change it, because it contains data for reconnecting, such as the rate and the odometry. */
struct frob_pioneer {
    const double *settings;
    struct frob_serial serial;
    struct frob_clock clock;
    struct frob_p2os_receiver receiver;

    enum frob_pioneer_phase phase;
    uint8_t sync;       /* number of the SYNC: 0, 1 or 2 */
    uint8_t attempt;    /* number of attempts in this phase */
    uint8_t tried;      /* number of bit rates tried so far */
    uint8_t step;       /* current step of opening the session */
    bool still_open;    /* whether a SIP has arrived after CLOSE */
    int64_t heard_ns;   /* time at which the last byte arrived */
    bool motors_seen;   /* whether the motors have been on in this session */
    int64_t until_ns;   /* time at which the phase times out or sends its next command */
    uint32_t rate;      /* current bit rate of the line */
    uint32_t good_rate; /* rate at which a robot has answered; 0 if unknown */
    uint32_t sync_rate; /* rate of the last successful handshake; 0 if unknown */
    bool switch_failed; /* whether nothing was received after the switch to another rate */
    bool rate_fixed;    /* whether the line rejected the last change of rate */

    struct frob_p2os_identity identity;
    struct frob_p2os_model model; /* the robot's model; settings may replace its factors */
    struct frob_p2os_robot_config config;
    bool has_config;
    uint8_t config_asked;
    int64_t config_due_ns;
    char description[3 * FROB_P2OS_NAME_ROOM + 16];

    int64_t sensed_ns;
    struct frob_p2os_sip sip; /* the newest SIP */
    bool has_counters;        /* whether a SIP has arrived in this session */
    uint16_t x, y;            /* position counters of that SIP */
    double turned_rad;        /* angle from the axes of the counters to those of odometry */
    struct frob_pose odometry;
    struct frob_pioneer_sonar sonar[FROB_PIONEER_SONARS];

    double forward_m_s, turn_rad_s;  /* the commanded speeds */
    struct frob_wire_numbers wanted; /* the same speeds as numbers for VEL and RVEL, or for VEL2
                                        (left, right) */
    struct frob_wire_numbers sent;   /* the numbers that the robot currently uses */
    bool has_wanted;                 /* whether there is a command that has not been sent */
    bool second_pending;             /* RVEL must follow VEL after a pause */
    int64_t sent_ns;                 /* time of the last command; INT64_MIN if none was sent yet */
};

extern const struct frob_driver frob_pioneer_driver;

/* Reads the last range of transducer `i` and its age. Returns false if the transducer has never
 * received an echo, or if nothing was in range. */
bool frob_pioneer_echo(const struct frob_pioneer *device, size_t i, double *range_m, double *age_s);

#ifdef __cplusplus
}
#endif
#endif
