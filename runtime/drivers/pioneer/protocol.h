/* protocol.h -- the numbers of the Pioneer commands and packets that the driver uses, under the
 * names that the manuals give them. */
#ifndef FROB_DRIVERS_PIONEER_PROTOCOL_H
#define FROB_DRIVERS_PIONEER_PROTOCOL_H

enum frob_p2os_command_number {
    FROB_P2OS_SYNC0 = 0, /* sent before a session; the robot echoes it */
    FROB_P2OS_SYNC1 = 1, /* sent second; the robot echoes it */
    FROB_P2OS_SYNC2 = 2, /* sent third; echoed with name, class and subclass */
    FROB_P2OS_PULSE = 0,
    FROB_P2OS_OPEN = 1,
    FROB_P2OS_CLOSE = 2,
    FROB_P2OS_ENABLE = 4,  /* motors: 1 on, 0 off */
    FROB_P2OS_VEL = 11,    /* mm/s */
    FROB_P2OS_CONFIG = 18, /* requests the config packet */
    FROB_P2OS_RVEL = 21,   /* deg/s, counter-clockwise */
    FROB_P2OS_SONAR = 28,  /* 1 on, 0 off */
    FROB_P2OS_STOP = 29,
    FROB_P2OS_VEL2 = 32,     /* bytes: right wheel, left wheel */
    FROB_P2OS_HOSTBAUD = 50, /* 0 to 4: 9600, 19200, 38400, 57600, 115200 */
    FROB_P2OS_E_STOP = 55    /* stop without the deceleration ramp */
};

enum frob_p2os_packet_type {
    FROB_P2OS_TYPE_CONFIG = 0x20,
    FROB_P2OS_TYPE_SIP_STOPPED = 0x32,
    FROB_P2OS_TYPE_SIP_MOVING = 0x33
};

/* Standard SIPs have the types 0x30 to 0x3F. */
#define FROB_P2OS_IS_SIP(type) (((type) & 0xF0) == 0x30)

#endif
