/* scout/packet.h -- packets of the Nomadic Scout's serial protocol.
 *
 * In both directions, at 38400 baud 8N1, a packet is
 *
 *     01  L  0  TYPE  DATA...  SUM  5C
 *
 * L is the total length of type, data and sum, in two bytes, low byte first. SUM is the sum of all
 * bytes before it, modulo 256. Numbers are sent low byte first. Signed numbers are in
 * sign-and-magnitude form, not two's complement: -100 is 64 80. The robot answers every command
 * with one packet, and sends nothing else.
 *
 * Source: Nomadics' direct-connection library, Ndirect 2.6.13 (Ndirect.c and Nclient.h, as in
 * CARMEN's scoutlib). This module does no I/O and does not allocate. */
#ifndef FROB_SCOUT_PACKET_H
#define FROB_SCOUT_PACKET_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Commands that a Scout accepts. A reply has the same type as its command. */
enum frob_scout_type {
    FROB_SCOUT_AC = 1,       /* accelerations */
    FROB_SCOUT_SP = 2,       /* speeds for PR */
    FROB_SCOUT_PR = 3,       /* move relative */
    FROB_SCOUT_VM = 5,       /* wheel velocities */
    FROB_SCOUT_GS = 7,       /* get state */
    FROB_SCOUT_NAK = 8,      /* reply only: refused */
    FROB_SCOUT_ST = 9,       /* stop and hold */
    FROB_SCOUT_LP = 10,      /* motors limp */
    FROB_SCOUT_DP = 12,      /* define the position */
    FROB_SCOUT_ZR = 13,      /* zero */
    FROB_SCOUT_CONF_SN = 15, /* sonar rate and firing order */
    FROB_SCOUT_CONF_TM = 18, /* watchdog */
    FROB_SCOUT_GET_SN = 20,  /* sonars */
    FROB_SCOUT_GET_RC = 21,  /* configuration: the pose */
    FROB_SCOUT_GET_RV = 22,  /* velocities */
    FROB_SCOUT_GET_BP = 27,  /* bumpers */
    FROB_SCOUT_DA = 30,      /* define the heading */
    FROB_SCOUT_WS = 31,      /* wait until stopped */
    FROB_SCOUT_MV = 43       /* a command for each axis */
};

enum {
    FROB_SCOUT_START = 0x01,
    FROB_SCOUT_END = 0x5C,
    /* Maximum length of the data. A state packet has 42 bytes. */
    FROB_SCOUT_MAX_DATA = 62,
    FROB_SCOUT_OVERHEAD = 6,
    FROB_SCOUT_MAX_PACKET = FROB_SCOUT_MAX_DATA + FROB_SCOUT_OVERHEAD
};

struct frob_scout_packet {
    uint8_t type;
    uint8_t count; /* length of data, at most FROB_SCOUT_MAX_DATA */
    uint8_t data[FROB_SCOUT_MAX_DATA];
};

/* Appends a number to the packet's data, which must have room for it. A magnitude above 32767 is
 * sent as 32767, the maximum of the protocol. */
void frob_scout_add_u8(struct frob_scout_packet *packet, unsigned value);
void frob_scout_add_u16(struct frob_scout_packet *packet, unsigned value);
void frob_scout_add_s16(struct frob_scout_packet *packet, long value);

/* Each reads a number from data. The ranges are 0 to 65535, -32767 to 32767, and 0 to 2^32 - 1. */
unsigned frob_scout_get_u16(const uint8_t *bytes);
int frob_scout_get_s16(const uint8_t *bytes);
uint32_t frob_scout_get_u32(const uint8_t *bytes);

/* Writes the packet as the bytes on the wire. Returns the number of bytes. */
size_t frob_scout_write_packet(const struct frob_scout_packet *packet,
                               uint8_t bytes[FROB_SCOUT_MAX_PACKET]);

/* The most recently received bytes. Initially all zero.
 *
 * From each byte that can end a packet, the receiver searches backwards for the start. Therefore
 * bytes before a packet never hide it, and every valid packet is found as soon as its last byte
 * arrives. */
struct frob_scout_receiver {
    uint8_t window[128]; /* ring buffer; its size is a power of two above FROB_SCOUT_MAX_PACKET */
    unsigned next;       /* index of the next byte */
};

/* Handles a received byte. If it completes a packet, stores it in `packet` and returns true;
 * otherwise `packet` stays unchanged. */
bool frob_scout_receive(struct frob_scout_receiver *receiver, uint8_t byte,
                        struct frob_scout_packet *packet);

#ifdef __cplusplus
}
#endif
#endif
