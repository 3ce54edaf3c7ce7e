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

/* Adds the header and the checksum to a packet that already contains its body. */
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

enum look { NOT_HERE, NOT_YET, HERE };

/* Checks whether these bytes begin with a packet. */
static enum look look(const uint8_t *at, size_t there)
{
    size_t count;
    if (at[0] != HEADER_1 || (there > 1 && at[1] != HEADER_2))
        return NOT_HERE;
    if (there < 3)
        return NOT_YET;
    count = at[2];
    if (count < FROB_P2OS_COUNT_LEAST || count > FROB_P2OS_COUNT_MOST)
        return NOT_HERE;
    if (there < count + 3)
        return NOT_YET;
    return frob_p2os_checksum(at + 3, count - 2) ==
                   (uint16_t)((uint16_t)(at[count + 1] << 8) | at[count + 2])
               ? HERE
               : NOT_HERE;
}

bool frob_p2os_next(struct frob_p2os_receiver *receiver, struct frob_p2os_packet *packet)
{
    bool waiting = false; /* the packet at `start` may still be incomplete */
    for (size_t i = receiver->start; i < receiver->end; i++) {
        const uint8_t *at = receiver->bytes + i;
        switch (look(at, receiver->end - i)) {
        case HERE:
            packet->body = at + 3;
            packet->length = at[2] - 2u;
            receiver->start = i + at[2] + 3u;
            receiver->in_step = true;
            return true;
        case NOT_YET:
            if (receiver->in_step)
                return false;
            waiting = true;
            break;
        case NOT_HERE:
            receiver->in_step = false;
            if (!waiting)
                receiver->start = i + 1;
            break;
        }
    }
    return false;
}
