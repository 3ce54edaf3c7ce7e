#include "drivers/create/sensors.h"

size_t frob_create_packet_size(unsigned id)
{
    /* Sizes of the packets from 7 on. Packets 32 and 33 are unused, but group 100 contains
     * them with these sizes. */
    static const uint8_t sizes[] = {
        1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, /* 7 to 18 */
        2, 2, 1, 2, 2, 1, 2, 2, 2,          /* 19 to 27 */
        2, 2, 2, 2, 1, 2, 1, 1, 1, 1, 1,    /* 28 to 38 */
        2, 2, 2, 2, 2, 2, 1,                /* 39 to 45 */
        2, 2, 2, 2, 2, 2, 1, 1,             /* 46 to 53 */
        2, 2, 2, 2, 1                       /* 54 to 58 */
    };
    if (id < 7 || id - 7 >= sizeof sizes)
        return 0;
    return sizes[id - 7];
}

static uint16_t u16(const uint8_t *data)
{
    return (uint16_t)((unsigned)data[0] << 8 | data[1]);
}

/* Interprets 16 bits as two's complement, portably. */
static int s16(unsigned value)
{
    return value < 0x8000u ? (int)value : (int)value - 0x10000;
}

bool frob_create_read_packet(unsigned id, const uint8_t *data, struct frob_create_sensors *s)
{
    switch (id) {
    case FROB_CREATE_BUMPS_AND_DROPS:
        s->bump_right = (data[0] & 1) != 0;
        s->bump_left = (data[0] & 2) != 0;
        s->drop_right = (data[0] & 4) != 0;
        s->drop_left = (data[0] & 8) != 0;
        return true;
    case FROB_CREATE_CLIFF_LEFT:
    case FROB_CREATE_CLIFF_FRONT_LEFT:
    case FROB_CREATE_CLIFF_FRONT_RIGHT:
    case FROB_CREATE_CLIFF_RIGHT: s->cliff[id - FROB_CREATE_CLIFF_LEFT] = data[0] != 0; return true;
    case FROB_CREATE_VIRTUAL_WALL: s->virtual_wall = data[0] != 0; return true;
    case FROB_CREATE_OVERCURRENT: s->overcurrent = data[0]; return true;
    case FROB_CREATE_INFRARED: s->infrared = data[0]; return true;
    case FROB_CREATE_BUTTONS: s->buttons = data[0]; return true;
    case FROB_CREATE_CHARGING: s->charging = data[0]; return true;
    case FROB_CREATE_VOLTAGE: s->battery_mv = u16(data); return true;
    case FROB_CREATE_CHARGE: s->charge_mah = u16(data); return true;
    case FROB_CREATE_CAPACITY: s->capacity_mah = u16(data); return true;
    case FROB_CREATE_CLIFF_LEFT_SIGNAL:
    case FROB_CREATE_CLIFF_FRONT_LEFT_SIGNAL:
    case FROB_CREATE_CLIFF_FRONT_RIGHT_SIGNAL:
    case FROB_CREATE_CLIFF_RIGHT_SIGNAL:
        s->cliff_signal[id - FROB_CREATE_CLIFF_LEFT_SIGNAL] = u16(data);
        return true;
    case FROB_CREATE_MODE: s->mode = data[0]; return true;
    case FROB_CREATE_LEFT_COUNTS: s->left_counts = u16(data); return true;
    case FROB_CREATE_RIGHT_COUNTS: s->right_counts = u16(data); return true;
    case FROB_CREATE_LIGHT_LEFT:
    case FROB_CREATE_LIGHT_FRONT_LEFT:
    case FROB_CREATE_LIGHT_CENTER_LEFT:
    case FROB_CREATE_LIGHT_CENTER_RIGHT:
    case FROB_CREATE_LIGHT_FRONT_RIGHT:
    case FROB_CREATE_LIGHT_RIGHT:
        s->light_signal[id - FROB_CREATE_LIGHT_LEFT] = u16(data);
        return true;
    default: return false;
    }
}

int frob_create_count_step(uint16_t before, uint16_t now)
{
    return s16(((unsigned)now - (unsigned)before) & 0xFFFFu);
}
