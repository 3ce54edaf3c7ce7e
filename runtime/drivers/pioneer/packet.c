#include "drivers/pioneer/packet.h"

#include <string.h>

enum { HEADER_1 = 0xFA, HEADER_2 = 0xFB };
enum { ARGUMENT_POSITIVE = 0x3B, ARGUMENT_NEGATIVE = 0x1B };

uint16_t frob_p2os_checksum(const uint8_t *body, size_t length)
{
    uint32_t sum = 0;
    size_t i;
    for (i = 0; i + 1 < length; i += 2)
        sum += (uint32_t)body[i] << 8 | body[i + 1];
    if (i < length)
        sum ^= body[i];
    return (uint16_t)(sum & 0xFFFFu);
}

/* Completes a packet whose body is in place. */
static size_t seal(uint8_t *packet, size_t length)
{
    uint16_t sum = frob_p2os_checksum(packet + 3, length);
    packet[0] = HEADER_1;
    packet[1] = HEADER_2;
    packet[2] = (uint8_t)(length + 2);
    packet[3 + length] = (uint8_t)(sum >> 8);
    packet[4 + length] = (uint8_t)(sum & 0xFFu);
    return length + 5;
}

size_t frob_p2os_command(uint8_t *packet, uint8_t command)
{
    packet[3] = command;
    return seal(packet, 1);
}

size_t frob_p2os_command_int(uint8_t *packet, uint8_t command, int32_t argument)
{
    uint32_t magnitude = argument < 0 ? 0u - (uint32_t)argument : (uint32_t)argument;
    if (magnitude > 0xFFFFu)
        magnitude = 0xFFFFu;
    packet[3] = command;
    packet[4] = argument < 0 ? ARGUMENT_NEGATIVE : ARGUMENT_POSITIVE;
    packet[5] = (uint8_t)(magnitude & 0xFFu);
    packet[6] = (uint8_t)(magnitude >> 8);
    return seal(packet, 4);
}

size_t frob_p2os_command_bytes(uint8_t *packet, uint8_t command, uint8_t low, uint8_t high)
{
    packet[3] = command;
    packet[4] = ARGUMENT_POSITIVE;
    packet[5] = low;
    packet[6] = high;
    return seal(packet, 4);
}

size_t frob_p2os_feed(struct frob_p2os_receiver *receiver, const uint8_t *bytes, size_t count)
{
    size_t room;
    if (receiver->start > 0) {
        receiver->end -= receiver->start;
        memmove(receiver->bytes, receiver->bytes + receiver->start, receiver->end);
        receiver->start = 0;
    }
    room = sizeof receiver->bytes - receiver->end;
    if (count > room)
        count = room;
    memcpy(receiver->bytes + receiver->end, bytes, count);
    receiver->end += count;
    return count;
}

bool frob_p2os_next(struct frob_p2os_receiver *receiver, struct frob_p2os_packet *packet)
{
    for (;;) {
        const uint8_t *at = receiver->bytes + receiver->start;
        size_t there = receiver->end - receiver->start;
        size_t count;
        if (there == 0)
            return false;
        if (at[0] != HEADER_1 || (there > 1 && at[1] != HEADER_2)) {
            receiver->start++;
            continue;
        }
        if (there < 3)
            return false;
        count = at[2];
        if (count < FROB_P2OS_COUNT_LEAST || count > FROB_P2OS_COUNT_MOST) {
            receiver->bad++;
            receiver->start++;
            continue;
        }
        if (there < count + 3)
            return false;
        if (frob_p2os_checksum(at + 3, count - 2) !=
            (uint16_t)((uint16_t)(at[count + 1] << 8) | at[count + 2])) {
            receiver->bad++;
            receiver->start++;
            continue;
        }
        receiver->good++;
        receiver->start += count + 3;
        packet->body = at + 3;
        packet->length = count - 2;
        return true;
    }
}
