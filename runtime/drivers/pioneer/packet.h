/* packet.h -- the packets of Pioneer robots (PSOS, P2OS, AROS, ARCOS).
 *
 * Bytes to packets and back, without any I/O. In both directions a packet is
 *
 *   FA FB  N  body  checksum
 *
 * where N counts the body and the checksum's two bytes. The body begins with
 * the command's number or the packet's type. The checksum is the sum of the
 * body's pairs of bytes (first byte high) modulo 65536; a byte left over is
 * XORed into its low byte. It is sent high byte first; all other numbers are
 * sent low byte first. There is no acknowledgement: a bad packet is dropped.
 *
 * Source: Pioneer 2 manual and ARCOS manual, "Client commands" and "Server
 * information packets"; packet.cc of Player's p2os driver agrees. */
#ifndef FROB_DRIVERS_PIONEER_PACKET_H
#define FROB_DRIVERS_PIONEER_PACKET_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The least and greatest N. The AROS manual allows up to 249. */
enum { FROB_P2OS_COUNT_LEAST = 3, FROB_P2OS_COUNT_MOST = 249 };
enum { FROB_P2OS_BODY_MOST = FROB_P2OS_COUNT_MOST - 2 };
enum { FROB_P2OS_PACKET_MOST = FROB_P2OS_COUNT_MOST + 3 };

/* The longest packet that the functions below make. */
enum { FROB_P2OS_COMMAND_MOST = 9 };

uint16_t frob_p2os_checksum(const uint8_t *body, size_t length);

/* Commands; each gives the packet's length. `packet` has room for
 * FROB_P2OS_COMMAND_MOST bytes. */
size_t frob_p2os_command(uint8_t *packet, uint8_t command);

/* With an integer argument, sent as a sign (in its type) and a magnitude of 16
 * bits; larger magnitudes are cut to 65535. */
size_t frob_p2os_command_int(uint8_t *packet, uint8_t command, int32_t argument);

/* With two raw bytes, as VEL2 has them. */
size_t frob_p2os_command_bytes(uint8_t *packet, uint8_t command, uint8_t low, uint8_t high);

/* A packet that has arrived. */
struct frob_p2os_packet {
    const uint8_t *body; /* in the receiver; good until it is fed again */
    size_t length;       /* at least 1 */
};

/* Finds packets in a stream of bytes. A bad packet costs one byte: the search
 * goes on behind its FA. What begins right behind a good packet is waited for to
 * its end, for the data of a packet may look like one. Anything else that may be
 * a packet and is not complete does not hide a good one behind it: so a good
 * packet after garbage is found with its last byte, whatever the garbage
 * announced (unless the sums make a packet of the garbage and the good one's
 * beginning, or garbage that begins like a packet follows a good one at once).
 * All zero is an empty receiver. */
struct frob_p2os_receiver {
    uint8_t bytes[2 * FROB_P2OS_PACKET_MOST];
    size_t start, end; /* of what is not yet looked at, or not complete */
    bool in_step;      /* `start` is right behind a good packet */
};

/* Adds bytes; gives how many it took, at least one if there are any and
 * frob_p2os_next has been called until it was false. */
size_t frob_p2os_feed(struct frob_p2os_receiver *receiver, const uint8_t *bytes, size_t count);

/* The next whole packet, if there is one. */
bool frob_p2os_next(struct frob_p2os_receiver *receiver, struct frob_p2os_packet *packet);

#ifdef __cplusplus
}
#endif
#endif
