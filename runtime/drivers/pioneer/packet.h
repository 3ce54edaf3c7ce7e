/* packet.h -- the packets of Pioneer robots (PSOS, P2OS, AROS, ARCOS).
 *
 * Converts bytes to packets and back, without any I/O. In both directions a packet is
 *
 *   FA FB  N  body  checksum
 *
 * where N is the length of the body plus the two bytes of the checksum. The body starts with the
 * command's number or the packet's type. The checksum is the sum of the body's pairs of bytes (high
 * byte first) modulo 65536; if one byte is left over, it is XORed into the low byte. The checksum
 * is sent high byte first; all other numbers are sent low byte first. There is no acknowledgement:
 * a bad packet is dropped.
 *
 * Source: Pioneer 2 manual and ARCOS manual, "Client commands" and "Server information packets";
 * packet.cc of Player's p2os driver agrees. */
#ifndef FROB_DRIVERS_PIONEER_PACKET_H
#define FROB_DRIVERS_PIONEER_PACKET_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Minimum and maximum of N. The AROS manual allows up to 249. */
enum { FROB_P2OS_COUNT_LEAST = 3, FROB_P2OS_COUNT_MOST = 249 };
enum { FROB_P2OS_BODY_MOST = FROB_P2OS_COUNT_MOST - 2 };
enum { FROB_P2OS_PACKET_MOST = FROB_P2OS_COUNT_MOST + 3 };

/* Length of the longest packet that the functions below write. */
enum { FROB_P2OS_COMMAND_MOST = 9 };

uint16_t frob_p2os_checksum(const uint8_t *body, size_t length);

/* These functions write commands and return the packet's length. `packet` must have room for
 * FROB_P2OS_COMMAND_MOST bytes. */
size_t frob_p2os_command(uint8_t *packet, uint8_t command);

/* Writes a command with an integer argument. The argument's type byte carries its sign; its
 * magnitude has 16 bits, and is clamped to 65535. */
size_t frob_p2os_command_int(uint8_t *packet, uint8_t command, int32_t argument);

/* Writes a command with two raw bytes, such as VEL2. */
size_t frob_p2os_command_bytes(uint8_t *packet, uint8_t command, uint8_t low, uint8_t high);

/* A received packet. */
struct frob_p2os_packet {
    const uint8_t *body; /* points into the receiver; valid until the next frob_p2os_feed */
    size_t length;       /* at least 1 */
};

/* Finds packets in a stream of bytes. After a bad packet, the search continues at the byte after
 * its FA. If bytes directly after a valid packet look like an incomplete packet, the receiver waits
 * for the rest of it, because the data of a packet may itself look like a packet. Elsewhere, an
 * incomplete packet does not hide a valid one after it. Therefore the receiver finds a valid packet
 * after garbage as soon as the packet's last byte arrives, whatever length bytes the garbage
 * contains. There are two exceptions: the garbage, together with the beginning of the valid packet,
 * may form a packet with a valid checksum, and garbage that looks like the start of a packet may
 * directly follow a valid packet. An all-zero receiver is empty. */
struct frob_p2os_receiver {
    uint8_t bytes[2 * FROB_P2OS_PACKET_MOST];
    size_t start, end; /* range of bytes that have not been examined yet, or that may belong to an
                        * incomplete packet */
    bool in_step;      /* whether `start` immediately follows a valid packet */
};

/* Adds bytes and returns the number added, which is at least 1 if `count` is not 0 and the last
 * call of frob_p2os_next returned false. */
size_t frob_p2os_feed(struct frob_p2os_receiver *receiver, const uint8_t *bytes, size_t count);

/* Finds the next complete packet. Returns false if there is none. */
bool frob_p2os_next(struct frob_p2os_receiver *receiver, struct frob_p2os_packet *packet);

#ifdef __cplusplus
}
#endif
#endif
