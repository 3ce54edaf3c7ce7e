/* Tests Pioneer packets byte for byte, with packets from the manuals and from captures. */
#include "check.h"

#include "drivers/pioneer/model.h"
#include "drivers/pioneer/protocol.h"
#include "drivers/pioneer/sip.h"

#include <string.h>

static bool is_bytes(const uint8_t *packet, size_t length, const char *expected, size_t count)
{
    return length == count && memcmp(packet, expected, count) == 0;
}

#define IS(packet, length, text) is_bytes(packet, length, text, sizeof(text) - 1)

static void commands(void)
{
    uint8_t p[FROB_P2OS_COMMAND_MOST];
    check(IS(p, frob_p2os_command(p, FROB_P2OS_SYNC0), "\xFA\xFB\x03\x00\x00\x00"), "SYNC0");
    check(IS(p, frob_p2os_command(p, FROB_P2OS_SYNC1), "\xFA\xFB\x03\x01\x00\x01"), "SYNC1");
    check(IS(p, frob_p2os_command(p, FROB_P2OS_SYNC2), "\xFA\xFB\x03\x02\x00\x02"), "SYNC2");
    check(IS(p, frob_p2os_command_int(p, FROB_P2OS_ENABLE, 1),
             "\xFA\xFB\x06\x04\x3B\x01\x00\x05\x3B"),
          "ENABLE 1");
    check(
        IS(p, frob_p2os_command_int(p, FROB_P2OS_VEL, 200), "\xFA\xFB\x06\x0B\x3B\xC8\x00\xD3\x3B"),
        "VEL 200");
    check(IS(p, frob_p2os_command_int(p, FROB_P2OS_VEL, -200),
             "\xFA\xFB\x06\x0B\x1B\xC8\x00\xD3\x1B"),
          "VEL -200: magnitude and a sign of its own");
    check(IS(p, frob_p2os_command_int(p, FROB_P2OS_VEL, INT32_MIN),
             "\xFA\xFB\x06\x0B\x1B\xFF\xFF\x0B\x1A"),
          "a magnitude beyond 16 bits is cut");
    check(IS(p, frob_p2os_command_bytes(p, FROB_P2OS_VEL2, 0x0A, 0xF6),
             "\xFA\xFB\x06\x20\x3B\x0A\xF6\x2B\x31"),
          "VEL2: right wheel, left wheel");
}

static size_t feed(struct frob_p2os_receiver *r, const void *bytes, size_t count,
                   struct frob_p2os_packet *last)
{
    const uint8_t *at = (const uint8_t *)bytes;
    size_t packets = 0;
    while (count > 0) {
        size_t taken = frob_p2os_feed(r, at, count);
        at += taken;
        count -= taken;
        while (frob_p2os_next(r, last))
            packets++;
    }
    return packets;
}

static void receiving(void)
{
    struct frob_p2os_receiver r = { { 0 }, 0, 0, false };
    struct frob_p2os_packet p;
    static const char pulse[] = "\xFA\xFB\x03\x00\x00\x00";
    bool split = true;
    check(feed(&r, pulse, 6, &p) == 1 && p.length == 1 && p.body[0] == 0, "a whole packet");
    for (size_t cut = 1; cut < 6; cut++)
        split = split && feed(&r, pulse, cut, &p) == 0 && feed(&r, pulse + cut, 6 - cut, &p) == 1;
    check(split, "a packet cut anywhere");
    check(feed(&r, "WMS2\rxx\xFA\xFA\xFB\x03\x01\x00\x01", 14, &p) == 1 && p.body[0] == 1,
          "junk before a packet, even half a header");
    check(feed(&r, "\xFA\xFB\x03\x00\x00\x01\xFA\xFB\x03\x02\x00\x02", 12, &p) == 1 &&
              p.body[0] == 2,
          "a wrong checksum drops one packet");
    check(feed(&r, "\xFA\xFB\x02\x00\xFA\xFB\xFA\xFA\xFB\x03\x02\x00\x02", 13, &p) == 1 &&
              p.body[0] == 2,
          "counts too small and too great");
    check(feed(&r, "\xFA\xFB\x09\xFA\xFB\x03\x01\x00\x01\x00\x00\x00", 12, &p) == 1 &&
              p.body[0] == 1,
          "a packet within a bad packet is found");
}

/* A robot at heading -90.5 degrees that creeps at 7 mm/s: its SIP contains FA FB 07 followed by
 * zeros, which is a valid packet with their checksum. */
static void data_like_a_packet(void)
{
    struct frob_p2os_receiver r = { { 0 }, 0, 0, false };
    struct frob_p2os_packet p = { NULL, 0 };
    uint8_t packet[64] = { 0xFA, 0xFB, 22, 0x32, 0, 0, 0, 0, 0xFA, 0xFB, 0x07 };
    uint16_t sum = frob_p2os_checksum(packet + 3, 20);
    size_t found = 0, others = 0;
    packet[23] = (uint8_t)(sum >> 8);
    packet[24] = (uint8_t)(sum & 0xFF);
    feed(&r, "\xFA\xFB\x03\x00\x00\x00", 6, &p);
    for (int round = 0; round < 10; round++) {
        for (size_t i = 0; i < 25; i++) {
            size_t packets = feed(&r, packet + i, 1, &p);
            found += packets == 1 && i == 24 && p.length == 20;
            others += packets == 1 && i != 24;
        }
    }
    check(found == 10 && others == 0, "data that looks like a packet is none");
}

/* After any garbage, the next valid packet must be found at its last byte, unless the two
 * together happen to form a packet, which is very rare. */
static void garbage_hides_nothing(void)
{
    uint32_t seed = 1;
    int missed = 0;
    for (int round = 0; round < 20000; round++) {
        struct frob_p2os_receiver r = { { 0 }, 0, 0, false };
        struct frob_p2os_packet p = { NULL, 0 };
        uint8_t garbage[64];
        for (size_t i = 0; i < sizeof garbage; i++) {
            seed = seed * 1664525u + 1013904223u;
            garbage[i] = (seed >> 28) < 5 ? 0xFA : (seed >> 28) < 10 ? 0xFB : (uint8_t)(seed >> 16);
        }
        feed(&r, garbage, sizeof garbage, &p);
        missed +=
            feed(&r, "\xFA\xFB\x03\x02\x00\x02", 6, &p) == 0 || p.body[0] != 2 || p.length != 1;
    }
    check(missed <= 3, "after garbage the next packet is found with its last byte");
}

static struct frob_p2os_packet body(const char *bytes, size_t length)
{
    struct frob_p2os_packet p = { (const uint8_t *)bytes, length };
    return p;
}

#define BODY(text) body(text, sizeof(text) - 1)

static void sip(void)
{
    /* moving; x 0x8005, y 0x7FFF, heading -1024; 200 and -100; 12.8 V; left
     * stall and rear bumper 0; front bumper 2; flags 1; two echoes */
    static const char bytes[] = "\x33\x05\x80\xFF\x7F\x00\xFC\xC8\x00\x9C\xFF\x80\x03\x08"
                                "\x00\x00\x01\x00\x00\x02\x03\xE8\x03\x0F\x88\x13"
                                "\x00\x00\x00\x00\x00";
    struct frob_p2os_packet p = BODY(bytes);
    struct frob_p2os_sip s;
    bool always = true;
    check(frob_p2os_read_sip(&p, &s) && s.moving, "a moving SIP");
    check(s.x == 5 && s.y == 0x7FFF, "positions have 15 bits");
    check(s.heading == -1024 && s.left == 200 && s.right == -100, "two's complement");
    check(s.battery == 128 && s.left_stall && !s.right_stall, "battery and stalls");
    check(s.rear_bumpers == 1 && s.front_bumpers == 4, "rear bumpers come first");
    check(s.flags == 1 && s.echo_count == 2 && s.echoes[0].transducer == 3 &&
              s.echoes[0].range == 1000 && s.echoes[1].transducer == 15 &&
              s.echoes[1].range == 5000,
          "only new echoes are in it");
    check(s.known == 0, "old firmware says no more");
    for (size_t length = 1; length < 26; length++) {
        struct frob_p2os_packet cut = body(bytes, length);
        always = always && !frob_p2os_read_sip(&cut, &s);
    }
    check(always, "a SIP cut within its echoes is none");
    p = BODY("\x32\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x7F\x00\x00\x00\x00\x00\x00\x00\x00"
             "\x00\x00\x00\x00\x00\x81\x00\x02\x9C\xFF\x05\x00");
    check(frob_p2os_read_sip(&p, &s) && !s.moving &&
              s.known == (FROB_P2OS_KNOWN_BATTERY | FROB_P2OS_KNOWN_CHARGE |
                          FROB_P2OS_KNOWN_TURN_RATE | FROB_P2OS_KNOWN_FAULTS) &&
              s.battery_fine == 129 && s.charge_state == 2 && s.turn_rate == -100 && s.faults == 5,
          "newer firmware says more");
    p = BODY("\x98\x00");
    check(!frob_p2os_read_sip(&p, &s), "other packets are no SIP");
}

static void names(void)
{
    static const char wire[] = "\xFA\xFB\x18\x02"
                               "AMRISim\0Pioneer\0p3dx\0\xEB\xBD";
    struct frob_p2os_receiver r = { { 0 }, 0, 0, false };
    struct frob_p2os_packet p;
    struct frob_p2os_identity who;
    size_t count;
    const struct frob_p2os_model *models = frob_p2os_models(&count);
    bool good = count == 18;
    check(feed(&r, wire, sizeof wire - 1, &p) == 1 && frob_p2os_read_identity(&p, &who),
          "the answer to SYNC2");
    check(strcmp(who.name, "AMRISim") == 0 && strcmp(who.robot_class, "Pioneer") == 0 &&
              strcmp(who.subclass, "p3dx") == 0,
          "name, class and subclass");
    p = BODY("\x02xyz");
    check(!frob_p2os_read_identity(&p, &who), "names without an end are none");
    check(frob_p2os_find_model("P3DX-SH") != NULL &&
              frob_p2os_find_model("P3DX-SH")->distance == 1.0 &&
              frob_p2os_find_model("p3dx")->distance == 0.485,
          "a subclass in any case");
    check(frob_p2os_find_model("p3d") == NULL && frob_p2os_find_model("p3dxx") == NULL &&
              frob_p2os_find_model("") == NULL,
          "not a part of a subclass");
    for (size_t i = 0; i < count; i++)
        good = good && frob_p2os_find_model(models[i].subclass) == &models[i];
    check(good, "eighteen models, each found");
}

static void config(void)
{
    struct frob_p2os_packet p =
        BODY("\x20Pioneer\0p3dx\0nr1\0\x04\xF4\x01\x98\x08\x2C\x01\xD0\x07\x90\x01name\0"
             "\x64\x00\x00\x00\x00\x01\x00\x01\x6E\x00\x00\x00\xD0\x07");
    struct frob_p2os_robot_config c;
    check(frob_p2os_read_config(&p, &c) && c.turn_top == 500 && c.speed_top == 2200 &&
              c.sip_period == 100 && c.watchdog == 2000,
          "the config packet");
    p.length--;
    check(!frob_p2os_read_config(&p, &c), "a config packet that is cut");
}

int main(void)
{
    commands();
    receiving();
    data_like_a_packet();
    garbage_hides_nothing();
    sip();
    names();
    config();
    return check_status();
}
