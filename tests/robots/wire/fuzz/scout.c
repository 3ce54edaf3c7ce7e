/* Fuzzes the Scout's packets: for any bytes, the receiver must find exactly the packets in them,
 * each at its last byte. */
#include "fuzz.h"
#include "random.h"

#include "drivers/scout/packet.h"
#include "drivers/scout/state.h"

#include <string.h>

size_t fuzz_frame(uint64_t *seed, uint8_t bytes[FUZZ_FRAME])
{
    struct frob_scout_packet packet;
    unsigned kind = random_below(seed, 4);
    packet.type = (uint8_t)random_below(seed, 44);
    packet.count = (uint8_t)(kind == 0 ? random_below(seed, FROB_SCOUT_MAX_DATA + 1)
                                       : (unsigned)FROB_SCOUT_STATE_DATA);
    for (size_t i = 0; i < packet.count; i++)
        packet.data[i] = (uint8_t)random_below(seed, 256);
    return frob_scout_write_packet(&packet, bytes);
}

/* The longest packet that ends just before `end`; 0 if there is none. */
static size_t packet_before(const uint8_t *bytes, size_t end)
{
    for (size_t size = FROB_SCOUT_MAX_PACKET; size >= 6; size--) {
        const uint8_t *at = bytes + end - size;
        unsigned sum = 0;
        if (size > end || at[0] != 0x01 || at[1] != size - 4 || at[2] != 0)
            continue;
        for (size_t i = 0; i < size - 2; i++)
            sum += at[i];
        if ((sum & 0xFF) == at[size - 2])
            return size;
    }
    return 0;
}

void fuzz_check(const uint8_t *bytes, size_t count)
{
    struct frob_scout_receiver receiver;
    struct frob_scout_packet packet;
    memset(&receiver, 0, sizeof receiver);
    for (size_t i = 0; i < count; i++) {
        bool found = frob_scout_receive(&receiver, bytes[i], &packet);
        size_t size = bytes[i] == 0x5C ? packet_before(bytes, i + 1) : 0;
        if (found != (size != 0))
            fuzz_fail("a packet is found where there is none, or missed");
        if (!found)
            continue;
        if (packet.count != size - 6 || packet.type != bytes[i + 4 - size] ||
            memcmp(packet.data, bytes + i + 5 - size, packet.count) != 0)
            fuzz_fail("a packet is not what was sent");
        if (frob_scout_is_state(&packet)) {
            struct frob_scout_state state = frob_scout_read_state(&packet);
            if (state.x < -32767 || state.x > 32767 || state.bumpers > 0xFFFFFF ||
                !(state.motor_v >= 0.0 && state.motor_v <= 20.0))
                fuzz_fail("a state is out of its range");
        }
    }
}
