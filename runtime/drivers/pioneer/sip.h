/* sip.h -- packets that Pioneer robots send: the standard information packet (SIP), the config
 * packet, and the answer to SYNC2. Converts packet bodies to structs in the units of the protocol,
 * without any I/O.
 *
 * Source: the same manuals as packet.h; offsets agree with Player's sip.cc and AriaCoda's
 * ArRobot.cpp. */
#ifndef FROB_DRIVERS_PIONEER_SIP_H
#define FROB_DRIVERS_PIONEER_SIP_H

#include "drivers/pioneer/packet.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { FROB_P2OS_SONARS_MOST = 32 };

struct frob_p2os_echo {
    uint8_t transducer;
    uint16_t range;
};

/* The standard SIP. The fields from `battery_fine` on exist only in newer firmware; `known` has a
 * bit for each of them that the packet contains. */
struct frob_p2os_sip {
    bool moving;
    uint16_t x, y; /* 15-bit counters that wrap around */
    int16_t heading;
    int16_t left, right; /* wheel speeds */
    uint8_t battery;     /* 0.1 V */
    bool left_stall, right_stall;
    uint8_t rear_bumpers, front_bumpers; /* one bit for each bumper, starting with bit 0 */
    uint16_t flags;
    uint8_t compass;
    uint8_t echo_count; /* a SIP omits sonars without new readings */
    struct frob_p2os_echo echoes[FROB_P2OS_SONARS_MOST];
    unsigned known;        /* bits of enum frob_p2os_known */
    uint16_t battery_fine; /* 0.1 V */
    uint8_t charge_state;
    int16_t turn_rate; /* 0.1 deg/s */
    uint16_t faults;
};

enum frob_p2os_known {
    FROB_P2OS_KNOWN_BATTERY = 1,
    FROB_P2OS_KNOWN_CHARGE = 2,
    FROB_P2OS_KNOWN_TURN_RATE = 4,
    FROB_P2OS_KNOWN_FAULTS = 8
};

/* Bits of `flags` (ARCOS). */
enum { FROB_P2OS_FLAG_MOTORS = 1 };

/* Returns false if the packet is not a SIP, or is shorter than its contents require. */
bool frob_p2os_read_sip(const struct frob_p2os_packet *packet, struct frob_p2os_sip *sip);

/* The part of the config packet that the driver uses. */
struct frob_p2os_robot_config {
    uint16_t turn_top;  /* deg/s */
    uint16_t speed_top; /* mm/s */
    uint8_t sip_period; /* ms */
    uint16_t watchdog;  /* ms */
};

bool frob_p2os_read_config(const struct frob_p2os_packet *packet,
                           struct frob_p2os_robot_config *config);

enum { FROB_P2OS_NAME_ROOM = 24 };

/* The answer to SYNC2. Names that do not fit are truncated. */
struct frob_p2os_identity {
    char name[FROB_P2OS_NAME_ROOM];
    char robot_class[FROB_P2OS_NAME_ROOM];
    char subclass[FROB_P2OS_NAME_ROOM];
};

bool frob_p2os_read_identity(const struct frob_p2os_packet *packet,
                             struct frob_p2os_identity *identity);

#ifdef __cplusplus
}
#endif
#endif
