/* Tests the Scout's packets with the bytes of the protocol's description. */
#include "check.h"
#include "random.h"

#include "drivers/scout/command.h"
#include "drivers/scout/packet.h"
#include "drivers/scout/sonar.h"
#include "drivers/scout/state.h"

#include <string.h>

static void sends(struct frob_scout_packet packet, const uint8_t *expected, size_t size,
                  const char *name)
{
    uint8_t bytes[FROB_SCOUT_MAX_PACKET];
    size_t written = frob_scout_write_packet(&packet, bytes);
    check(written == size && memcmp(bytes, expected, size) == 0, name);
}

static void commands(void)
{
    static const uint8_t get_state[] = { 0x01, 0x02, 0x00, 0x07, 0x0A, 0x5C };
    static const uint8_t velocities[] = { 0x01, 0x08, 0x00, 0x05, 0x64, 0x00,
                                          0x64, 0x80, 0x00, 0x00, 0x56, 0x5C };
    static const uint8_t acceleration[] = { 0x01, 0x08, 0x00, 0x01, 0x2C, 0x01,
                                            0x2C, 0x01, 0x00, 0x00, 0x64, 0x5C };
    static const uint8_t watchdog[] = { 0x01, 0x03, 0x00, 0x12, 0x05, 0x1B, 0x5C };
    static const uint8_t sonars[] = { 0x01, 0x13, 0x00, 0x0F, 0x0F, 0x00, 0x02, 0x0F,
                                      0x01, 0x0E, 0x03, 0x0D, 0x04, 0x0C, 0x05, 0x0B,
                                      0x06, 0x0A, 0x07, 0x09, 0x08, 0xAA, 0x5C };
    struct frob_scout_packet off = frob_scout_sonars_off();
    sends(frob_scout_plain(FROB_SCOUT_GS), get_state, sizeof get_state, "get state");
    sends(frob_scout_velocities(100, -100), velocities, sizeof velocities,
          "velocities, sign and magnitude");
    sends(frob_scout_acceleration(300), acceleration, sizeof acceleration, "acceleration");
    sends(frob_scout_watchdog(5), watchdog, sizeof watchdog, "watchdog");
    sends(frob_scout_sonars_on(15), sonars, sizeof sonars, "sonars on, in the usual order");
    check(off.count == 17 && off.data[1] == 255, "sonars off: an order that ends at once");
}

static void numbers(void)
{
    struct frob_scout_packet packet = frob_scout_plain(FROB_SCOUT_VM);
    static const uint8_t minus_zero[] = { 0x00, 0x80 };
    bool equal = true;
    for (long n = -32767; n <= 32767; n++) {
        packet.count = 0;
        frob_scout_add_s16(&packet, n);
        equal = equal && frob_scout_get_s16(packet.data) == n;
    }
    check(equal, "every signed number reads as it was written");
    check(frob_scout_get_s16(minus_zero) == 0, "minus zero is zero");
    packet.count = 0;
    frob_scout_add_s16(&packet, -1000000);
    frob_scout_add_s16(&packet, 1000000);
    check(frob_scout_get_s16(packet.data) == -32767 && frob_scout_get_s16(packet.data + 2) == 32767,
          "what the wire cannot hold is its largest number");
}

/* A state packet with a different value in every field. */
static const uint8_t state_data[FROB_SCOUT_STATE_DATA] = {
    255,  17,   18,   19,   20,   21,   22,   23,   24, 25, 26, 27, 28, 29, 30, 31, /* sonars */
    0x01, 0x02, 0x80,                                                               /* bumpers */
    0xE8, 0x03, 0xD0, 0x87,                         /* x 1000, y -2000 */
    0x08, 0x07, 0x08, 0x07,                         /* heading 1800, turret */
    0x64, 0x00, 0x64, 0x80, 0x00, 0x00, 0x00, 0x00, /* velocities, compass */
    0x5B, 0x78, 0x56, 0x34, 0x12, 0xFF, 0x00,       /* status, time, voltages */
};

static struct frob_scout_packet state_packet(uint8_t type)
{
    struct frob_scout_packet packet = frob_scout_plain(FROB_SCOUT_GS);
    packet.type = type;
    packet.count = sizeof state_data;
    memcpy(packet.data, state_data, sizeof state_data);
    return packet;
}

static void state(void)
{
    struct frob_scout_packet packet = state_packet(FROB_SCOUT_VM);
    struct frob_scout_state s;
    uint8_t bytes[FROB_SCOUT_MAX_PACKET];
    check(frob_scout_write_packet(&packet, bytes) == 48, "a state packet has 48 bytes");
    check(frob_scout_is_state(&packet), "the answer to velocities is a state");
    s = frob_scout_read_state(&packet);
    check(s.sonar_in[0] == 255 && s.sonar_in[15] == 31, "sonars");
    check(s.bumpers == 0x800201, "bumpers, the first byte lowest");
    check(s.x == 1000 && s.y == -2000 && s.heading == 1800, "pose");
    check((s.motor_status & FROB_SCOUT_EMERGENCY_STOP) != 0 &&
              (s.motor_status & FROB_SCOUT_PLUGGED_IN) != 0 &&
              (s.motor_status & FROB_SCOUT_CHARGING) == 0,
          "motor status");
    check(s.time_ms == 0x12345678, "time");
    check_near(s.cpu_v, 12.0, 1e-9, "processor's voltage");
    check_near(s.motor_v, 5.14, 1e-9, "motors' voltage");
    packet.type = FROB_SCOUT_NAK;
    check(!frob_scout_is_state(&packet), "a refusal is no state");
    packet.type = FROB_SCOUT_VM;
    packet.count--;
    check(!frob_scout_is_state(&packet), "a short packet is no state");
}

static void steps(void)
{
    check(frob_scout_position_step(100, 90) == -10, "a step back");
    check(frob_scout_position_step(32767, 0) == 1, "x wraps to zero");
    check(frob_scout_position_step(-32767, 0) == -1, "x wraps to zero from below");
    check(frob_scout_position_step(32766, -32766) == 4, "x wraps to the negative end");
    check(frob_scout_heading_step(3590, 10) == 20, "heading wraps at 360 degrees");
    check(frob_scout_heading_step(-1790, 1790) == -20, "heading wraps at 180 degrees");
    check(frob_scout_heading_step(0, 1800) == 1800, "half a turn");
}

/* Garbage that often consists of typical packet bytes, then a packet, which must be found at its
 * last byte; packets found earlier must end before it. */
static void garbage(void)
{
    static const uint8_t likely[] = { 0x01, 0x02, 0x2C, 0x00, 0x5C, 0x07 };
    uint64_t seed = 1;
    unsigned missed = 0, invented = 0;
    struct frob_scout_receiver receiver;
    memset(&receiver, 0, sizeof receiver);
    for (int round = 0; round < 100000; round++) {
        struct frob_scout_packet found, packet = state_packet(FROB_SCOUT_GS);
        uint8_t bytes[FROB_SCOUT_MAX_PACKET];
        size_t size;
        for (unsigned n = random_below(&seed, 80); n > 0; n--) {
            uint64_t r = random_next(&seed);
            uint8_t byte = (r & 3) == 0 ? likely[(r >> 8) % sizeof likely] : (uint8_t)(r >> 16);
            invented += frob_scout_receive(&receiver, byte, &found);
        }
        packet.data[35] = (uint8_t)random_below(&seed, 256);
        size = frob_scout_write_packet(&packet, bytes);
        for (size_t i = 0; i + 1 < size; i++)
            invented += frob_scout_receive(&receiver, bytes[i], &found);
        found.type = 0;
        missed += !frob_scout_receive(&receiver, bytes[size - 1], &found) ||
                  found.type != packet.type || found.count != packet.count ||
                  memcmp(found.data, packet.data, packet.count) != 0;
    }
    check(missed == 0, "a packet after any garbage is found with its last byte");
    /* Six random bytes form a packet with a probability of about 2^-32; the typical bytes raise
     * it. */
    check(invented < 20, "garbage is hardly ever a packet");
}

/* Every single bit error, lost byte and duplicated byte of a packet must be detected. */
static void errors(void)
{
    struct frob_scout_packet packet = state_packet(FROB_SCOUT_GS), found;
    uint8_t bytes[FROB_SCOUT_MAX_PACKET];
    size_t size = frob_scout_write_packet(&packet, bytes);
    unsigned accepted = 0;
    for (size_t bit = 0; bit < 8 * size; bit++) {
        struct frob_scout_receiver receiver;
        memset(&receiver, 0, sizeof receiver);
        for (size_t i = 0; i < size; i++)
            accepted += frob_scout_receive(
                &receiver, (uint8_t)(bytes[i] ^ (i == bit / 8 ? 1u << bit % 8 : 0u)), &found);
    }
    for (size_t lost = 0; lost < size; lost++) {
        struct frob_scout_receiver receiver;
        memset(&receiver, 0, sizeof receiver);
        for (size_t i = 0; i < size; i++)
            accepted += i != lost && frob_scout_receive(&receiver, bytes[i], &found);
    }
    check(accepted == 0, "a packet with a wrong bit or without a byte is no packet");
}

/* States arrive every 20 ms; a transducer fires every 640 ms. Its reading is the same in the
 * first two rounds, and different in the third, whose echo comes 30 ms later. The driver must
 * report one echo per round, and not repeat the old reading. */
static void turns(void)
{
    struct frob_scout_sonar sonar;
    struct frob_scout_state state;
    double distance_m[8], d;
    int64_t at_ms[8];
    size_t count = 0;
    memset(&sonar, 0, sizeof sonar);
    memset(&state, 0, sizeof state);
    for (int64_t ms = 0; ms < 2560; ms += 20) {
        state.sonar_in[3] = (uint8_t)(ms < 1280 + 30 ? 40 : 30);
        frob_scout_sonar_add(&sonar, &state, ms * 1000000, 640 * INT64_C(1000000));
        if (frob_scout_sonar_take(&sonar, 3, &d) && count < 8) {
            distance_m[count] = d;
            at_ms[count++] = ms;
        }
    }
    check(count == 4 && at_ms[0] == 0 && at_ms[1] == 720 && at_ms[2] == 1320 && at_ms[3] == 2040,
          "a transducer is heard once in each of its turns");
    check(count == 4 && distance_m[1] > 1.0 && distance_m[2] < 0.8 && distance_m[3] < 0.8,
          "an old reading is not taken for new when the next one is late");
}

int main(void)
{
    turns();
    commands();
    numbers();
    state();
    steps();
    garbage();
    errors();
    return check_status();
}
