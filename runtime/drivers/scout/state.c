#include "drivers/scout/state.h"

#include <assert.h>

/* Offsets in a packet's data. */
enum {
    SONAR = 0,
    BUMPERS = 16,
    X = 19,
    Y = 21,
    HEADING = 23,
    STATUS = 35,
    TIME = 36,
    VOLTAGES = 40
};

bool frob_scout_is_state(const struct frob_scout_packet *packet)
{
    if (packet->count < FROB_SCOUT_STATE_DATA)
        return false;
    switch (packet->type) {
    case FROB_SCOUT_AC:
    case FROB_SCOUT_SP:
    case FROB_SCOUT_PR:
    case FROB_SCOUT_VM:
    case FROB_SCOUT_GS:
    case FROB_SCOUT_ST:
    case FROB_SCOUT_LP:
    case FROB_SCOUT_DP:
    case FROB_SCOUT_ZR:
    case FROB_SCOUT_CONF_SN:
    case FROB_SCOUT_CONF_TM:
    case FROB_SCOUT_DA:
    case FROB_SCOUT_WS:
    case FROB_SCOUT_MV: return true;
    default: return false;
    }
}

/* According to Ndirect, volts = (2 + 3 raw / 255) range / 5. */
static double volts(unsigned raw, double range)
{
    return (2.0 + 3.0 * raw / 255.0) * range / 5.0;
}

struct frob_scout_state frob_scout_read_state(const struct frob_scout_packet *packet)
{
    const uint8_t *data = packet->data;
    struct frob_scout_state state;
    assert(frob_scout_is_state(packet));
    for (size_t i = 0; i < FROB_SCOUT_SONARS; i++)
        state.sonar_in[i] = data[SONAR + i];
    state.bumpers = (uint32_t)frob_scout_get_u16(data + BUMPERS) | (uint32_t)data[BUMPERS + 2]
                                                                       << 16;
    state.x = frob_scout_get_s16(data + X);
    state.y = frob_scout_get_s16(data + Y);
    state.heading = frob_scout_get_s16(data + HEADING);
    state.motor_status = data[STATUS];
    state.time_ms = frob_scout_get_u32(data + TIME);
    state.cpu_v = volts(data[VOLTAGES], 12.0);
    state.motor_v = volts(data[VOLTAGES + 1], 12.85);
    return state;
}

/* Returns the number nearest to 0 that is congruent to `step` modulo `period`, and the positive one
 * if there are two; |step| is below 2^17. */
static int nearest(int step, int period)
{
    step %= period;
    if (step > period / 2)
        return step - period;
    if (step <= -period / 2)
        return step + period;
    return step;
}

int frob_scout_position_step(int before, int now)
{
    return nearest(now - before, 32768);
}

int frob_scout_heading_step(int before, int now)
{
    return nearest(now - before, 3600);
}
