#include "drivers/scout/command.h"

struct frob_scout_packet frob_scout_plain(enum frob_scout_type type)
{
    struct frob_scout_packet packet = { 0, 0, { 0 } };
    packet.type = (uint8_t)type;
    return packet;
}

struct frob_scout_packet frob_scout_acceleration(unsigned both)
{
    struct frob_scout_packet packet = frob_scout_plain(FROB_SCOUT_AC);
    frob_scout_add_u16(&packet, both);
    frob_scout_add_u16(&packet, both);
    frob_scout_add_u16(&packet, 0);
    return packet;
}

struct frob_scout_packet frob_scout_velocities(long first, long second)
{
    struct frob_scout_packet packet = frob_scout_plain(FROB_SCOUT_VM);
    frob_scout_add_s16(&packet, first);
    frob_scout_add_s16(&packet, second);
    frob_scout_add_s16(&packet, 0);
    return packet;
}

struct frob_scout_packet frob_scout_sonars_on(unsigned rate)
{
    static const uint8_t order[FROB_SCOUT_SONARS] = { 0,  2, 15, 1, 14, 3, 13, 4,
                                                      12, 5, 11, 6, 10, 7, 9,  8 };
    struct frob_scout_packet packet = frob_scout_plain(FROB_SCOUT_CONF_SN);
    frob_scout_add_u8(&packet, rate);
    for (size_t i = 0; i < FROB_SCOUT_SONARS; i++)
        frob_scout_add_u8(&packet, order[i]);
    return packet;
}

struct frob_scout_packet frob_scout_sonars_off(void)
{
    struct frob_scout_packet packet = frob_scout_plain(FROB_SCOUT_CONF_SN);
    frob_scout_add_u8(&packet, 0);
    for (size_t i = 0; i < FROB_SCOUT_SONARS; i++)
        frob_scout_add_u8(&packet, 255);
    return packet;
}

struct frob_scout_packet frob_scout_watchdog(unsigned seconds)
{
    struct frob_scout_packet packet = frob_scout_plain(FROB_SCOUT_CONF_TM);
    frob_scout_add_u8(&packet, seconds);
    return packet;
}
