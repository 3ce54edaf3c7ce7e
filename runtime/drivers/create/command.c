#include "drivers/create/command.h"

#include "drivers/create/stream.h"

#include <assert.h>

size_t frob_create_plain(enum frob_create_opcode opcode, uint8_t *bytes)
{
    bytes[0] = (uint8_t)opcode;
    return 1;
}

static void put_speed(int mm_s, uint8_t *bytes)
{
    unsigned value;
    if (mm_s > FROB_CREATE_MAX_SPEED_MM_S)
        mm_s = FROB_CREATE_MAX_SPEED_MM_S;
    if (mm_s < -FROB_CREATE_MAX_SPEED_MM_S)
        mm_s = -FROB_CREATE_MAX_SPEED_MM_S;
    value = (unsigned)mm_s & 0xFFFFu;
    bytes[0] = (uint8_t)(value >> 8);
    bytes[1] = (uint8_t)(value & 0xFFu);
}

size_t frob_create_drive_direct(int right_mm_s, int left_mm_s, uint8_t *bytes)
{
    bytes[0] = FROB_CREATE_DRIVE_DIRECT;
    put_speed(right_mm_s, bytes + 1);
    put_speed(left_mm_s, bytes + 3);
    return 5;
}

size_t frob_create_stream_request(const uint8_t *ids, size_t count, uint8_t *bytes)
{
    assert(count <= FROB_CREATE_MAX_IDS);
    bytes[0] = FROB_CREATE_STREAM;
    bytes[1] = (uint8_t)count;
    for (size_t i = 0; i < count; i++)
        bytes[2 + i] = ids[i];
    return 2 + count;
}

size_t frob_create_stream_pause(uint8_t *bytes)
{
    bytes[0] = FROB_CREATE_PAUSE_STREAM;
    bytes[1] = 0;
    return 2;
}

size_t frob_create_leds(unsigned lights, unsigned colour, unsigned brightness, uint8_t *bytes)
{
    bytes[0] = FROB_CREATE_LEDS;
    bytes[1] = (uint8_t)(lights & 0x0Fu);
    bytes[2] = (uint8_t)(colour & 0xFFu);
    bytes[3] = (uint8_t)(brightness & 0xFFu);
    return 4;
}

size_t frob_create_note(unsigned note, unsigned duration, uint8_t *bytes)
{
    bytes[0] = FROB_CREATE_SONG;
    bytes[1] = 0; /* the song's number */
    bytes[2] = 1; /* notes */
    bytes[3] = (uint8_t)(note & 0xFFu);
    bytes[4] = (uint8_t)(duration & 0xFFu);
    bytes[5] = FROB_CREATE_PLAY;
    bytes[6] = 0;
    return 7;
}
