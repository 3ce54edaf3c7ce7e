/* Fuzzes the Pioneer's packets: for any bytes in any portions, the receiver must find exactly
 * the complete packets, each as soon as it is complete. */
#include "fuzz.h"
#include "random.h"

#include "drivers/pioneer/packet.h"
#include "drivers/pioneer/sip.h"

#include <string.h>

size_t fuzz_frame(uint64_t *seed, uint8_t bytes[FUZZ_FRAME])
{
    static const uint8_t types[] = { 0x32, 0x33, 0x20, 0x02 };
    size_t length = 1 + random_below(seed, random_below(seed, 4) == 0 ? 246 : 84);
    uint16_t sum;
    bytes[0] = 0xFA;
    bytes[1] = 0xFB;
    bytes[2] = (uint8_t)(length + 2);
    bytes[3] = types[random_below(seed, sizeof types)];
    for (size_t i = 1; i < length; i++)
        bytes[3 + i] = (uint8_t)random_below(seed, 256);
    if (length > 19)
        bytes[3 + 19] = (uint8_t)random_below(seed, 24); /* number of sonar readings */
    sum = frob_p2os_checksum(bytes + 3, length);
    bytes[3 + length] = (uint8_t)(sum >> 8);
    bytes[4 + length] = (uint8_t)(sum & 0xFF);
    return length + 5;
}

/* The manual's checksum, over pairs of bytes, implemented differently from the driver. */
static unsigned sum_of(const uint8_t *body, size_t length)
{
    unsigned sum = 0;
    for (size_t i = 0; i < length / 2 * 2; i++)
        sum = (sum + (i % 2 == 0 ? body[i] * 256u : body[i])) % 65536u;
    return length % 2 != 0 ? sum ^ body[length - 1] : sum;
}

/* Whether the bytes from `at` on are the start of a packet that may be completed. */
static bool is_begun(const uint8_t *bytes, size_t count, size_t at)
{
    return at < count && bytes[at] == 0xFA && (at + 1 >= count || bytes[at + 1] == 0xFB) &&
           (at + 2 >= count ||
            (bytes[at + 2] >= 3 && bytes[at + 2] <= 249 && at + 3 + bytes[at + 2] > count));
}

/* The first complete packet from `from` on: its start and end. If the start of a packet is right
 * `behind` another packet, the search waits for it. */
static bool next_packet(const uint8_t *bytes, size_t count, size_t from, bool behind, size_t *at,
                        size_t *end)
{
    if (behind && is_begun(bytes, count, from))
        return false;
    for (*at = from; *at + 5 < count; ++*at) {
        size_t announced = bytes[*at + 2];
        if (bytes[*at] != 0xFA || bytes[*at + 1] != 0xFB || announced < 3 || announced > 249)
            continue;
        *end = *at + 3 + announced;
        if (*end <= count &&
            sum_of(bytes + *at + 3, announced - 2) == bytes[*end - 2] * 256u + bytes[*end - 1])
            return true;
    }
    return false;
}

static void read_packet(const struct frob_p2os_packet *packet)
{
    struct frob_p2os_sip sip;
    struct frob_p2os_robot_config config;
    struct frob_p2os_identity identity;
    if (frob_p2os_read_sip(packet, &sip) && sip.echo_count > FROB_P2OS_SONARS_MOST)
        fuzz_fail("a packet has more echoes than there is room for");
    if (frob_p2os_read_identity(packet, &identity) &&
        (memchr(identity.name, 0, sizeof identity.name) == NULL ||
         memchr(identity.robot_class, 0, sizeof identity.robot_class) == NULL ||
         memchr(identity.subclass, 0, sizeof identity.subclass) == NULL))
        fuzz_fail("a name has no end");
    frob_p2os_read_config(packet, &config);
}

void fuzz_check(const uint8_t *bytes, size_t count)
{
    struct frob_p2os_receiver receiver;
    struct frob_p2os_packet packet;
    size_t fed = 0, from = 0, at = 0, end = 0;
    uint64_t seed = count;
    bool behind = false;
    memset(&receiver, 0, sizeof receiver);
    while (fed < count) {
        size_t portion = 1 + random_below(&seed, 300);
        size_t used =
            frob_p2os_feed(&receiver, bytes + fed, portion < count - fed ? portion : count - fed);
        if (used == 0)
            fuzz_fail("the receiver takes nothing");
        /* A packet that started longer ago than the longest packet was complete before. */
        if (fed > FROB_P2OS_PACKET_MOST && from < fed - FROB_P2OS_PACKET_MOST) {
            from = fed - FROB_P2OS_PACKET_MOST;
            behind = false;
        }
        fed += used;
        while (frob_p2os_next(&receiver, &packet)) {
            if (!next_packet(bytes, fed, from, behind, &at, &end))
                fuzz_fail("a packet is found where there is none");
            if (packet.length != end - at - 5 ||
                memcmp(packet.body, bytes + at + 3, packet.length) != 0)
                fuzz_fail("a packet is not what was sent");
            from = end;
            behind = true;
            read_packet(&packet);
        }
        if (next_packet(bytes, fed, from, behind, &at, &end))
            fuzz_fail("a packet is missed");
    }
}
