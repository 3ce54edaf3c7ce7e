#include "drivers/scout/packet.h"

#include <assert.h>

void frob_scout_add_u8(struct frob_scout_packet *packet, unsigned value)
{
    assert(packet->count < FROB_SCOUT_MAX_DATA);
    packet->data[packet->count++] = (uint8_t)(value & 0xFFu);
}

void frob_scout_add_u16(struct frob_scout_packet *packet, unsigned value)
{
    frob_scout_add_u8(packet, value);
    frob_scout_add_u8(packet, value >> 8);
}

void frob_scout_add_s16(struct frob_scout_packet *packet, long value)
{
    unsigned long magnitude = value < 0 ? 0ul - (unsigned long)value : (unsigned long)value;
    if (magnitude > 0x7FFFul)
        magnitude = 0x7FFFul;
    frob_scout_add_u16(packet, (unsigned)magnitude | (value < 0 ? 0x8000u : 0u));
}

unsigned frob_scout_get_u16(const uint8_t *bytes)
{
    return (unsigned)bytes[0] | (unsigned)bytes[1] << 8;
}

int frob_scout_get_s16(const uint8_t *bytes)
{
    unsigned value = frob_scout_get_u16(bytes);
    int magnitude = (int)(value & 0x7FFFu);
    return (value & 0x8000u) != 0 ? -magnitude : magnitude;
}

uint32_t frob_scout_get_u32(const uint8_t *bytes)
{
    return (uint32_t)frob_scout_get_u16(bytes) | (uint32_t)frob_scout_get_u16(bytes + 2) << 16;
}

size_t frob_scout_write_packet(const struct frob_scout_packet *packet,
                               uint8_t bytes[FROB_SCOUT_MAX_PACKET])
{
    size_t size = 0;
    unsigned sum = 0;
    assert(packet->count <= FROB_SCOUT_MAX_DATA);
    bytes[size++] = FROB_SCOUT_START;
    bytes[size++] = (uint8_t)(packet->count + 2);
    bytes[size++] = 0;
    bytes[size++] = packet->type;
    for (size_t i = 0; i < packet->count; i++)
        bytes[size++] = packet->data[i];
    for (size_t i = 0; i < size; i++)
        sum += bytes[i];
    bytes[size++] = (uint8_t)(sum & 0xFFu);
    bytes[size++] = FROB_SCOUT_END;
    return size;
}

enum { WINDOW_MASK = sizeof(((struct frob_scout_receiver *)0)->window) - 1 };

/* Returns the byte at `index` of the last `size` bytes received. */
static unsigned at(const struct frob_scout_receiver *r, unsigned size, unsigned index)
{
    return r->window[(r->next - size + index) & WINDOW_MASK];
}

/* Returns whether the last `size` bytes are a packet. The caller has checked the last byte. */
static bool is_packet(const struct frob_scout_receiver *r, unsigned size)
{
    unsigned sum = 0;
    if (at(r, size, 0) != FROB_SCOUT_START || at(r, size, 1) != size - 4 || at(r, size, 2) != 0)
        return false;
    for (unsigned i = 0; i < size - 2; i++)
        sum += at(r, size, i);
    return (sum & 0xFFu) == at(r, size, size - 2);
}

bool frob_scout_receive(struct frob_scout_receiver *r, uint8_t byte,
                        struct frob_scout_packet *packet)
{
    r->window[r->next] = byte;
    r->next = (r->next + 1) & WINDOW_MASK;
    if (byte != FROB_SCOUT_END)
        return false;
    /* Tries the longest packet first, because a shorter one could be part of its data. */
    for (unsigned size = FROB_SCOUT_MAX_PACKET; size >= FROB_SCOUT_OVERHEAD; size--) {
        if (!is_packet(r, size))
            continue;
        packet->type = (uint8_t)at(r, size, 3);
        packet->count = (uint8_t)(size - FROB_SCOUT_OVERHEAD);
        for (unsigned i = 0; i < packet->count; i++)
            packet->data[i] = (uint8_t)at(r, size, 4 + i);
        return true;
    }
    return false;
}
