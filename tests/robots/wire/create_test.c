/* Tests the Create 2's commands and frames with the bytes of the protocol's description. */
#include "check.h"
#include "random.h"

#include "drivers/create/command.h"
#include "drivers/create/sensors.h"
#include "drivers/create/stream.h"

#include <string.h>

static void commands(void)
{
    static const uint8_t ids[] = { 29, 13 };
    static const uint8_t turning[] = { 0x91, 0x00, 0x64, 0x00, 0xC8 };
    static const uint8_t limited[] = { 0x91, 0xFE, 0x0C, 0x01, 0xF4 };
    static const uint8_t request[] = { 148, 2, 29, 13 };
    uint8_t bytes[FROB_CREATE_MAX_COMMAND];
    check(frob_create_drive_direct(100, 200, bytes) == 5 && memcmp(bytes, turning, 5) == 0,
          "drive direct, right wheel first");
    check(frob_create_drive_direct(-100000, 100000, bytes) == 5 && memcmp(bytes, limited, 5) == 0,
          "speeds are limited, negative ones in two's complement");
    check(frob_create_stream_request(ids, 2, bytes) == 4 && memcmp(bytes, request, 4) == 0,
          "stream request");
    check(frob_create_plain(FROB_CREATE_SAFE, bytes) == 1 && bytes[0] == 131, "safe mode");
    check(frob_create_stream_pause(bytes) == 2 && bytes[0] == 150 && bytes[1] == 0, "pause");
}

static void sizes(void)
{
    size_t all = 0, lights = 0, all_with_ids = 0;
    for (unsigned id = 0; id < 256; id++) {
        all += frob_create_packet_size(id);
        all_with_ids += frob_create_packet_size(id) > 0;
        lights += id >= 46 && id <= 51 ? frob_create_packet_size(id) : 0;
    }
    check(all == 80 && all_with_ids == FROB_CREATE_MAX_IDS,
          "packets 7 to 58 have 80 bytes, as group 100");
    check(lights == 12, "the light bumpers have 12 bytes, as group 106");
}

/* Feeds bytes; returns the number of frames that they completed. */
static unsigned receive(struct frob_create_stream *stream, const uint8_t *bytes, size_t count,
                        struct frob_create_sensors *sensors)
{
    unsigned frames = 0;
    for (size_t i = 0; i < count; i++)
        frames += frob_create_stream_receive(stream, bytes[i], sensors);
    return frames;
}

static void checksums(void)
{
    static const uint8_t ids[] = { 29, 13 };
    static const uint8_t create_2[] = { 0x13, 0x05, 0x1D, 0x02, 0x19, 0x0D, 0x00, 0xA3 };
    static const uint8_t create_1[] = { 0x13, 0x05, 0x1D, 0x02, 0x19, 0x0D, 0x01, 0xB5 };
    struct frob_create_stream stream;
    struct frob_create_sensors sensors;
    memset(&sensors, 0, sizeof sensors);
    sensors.virtual_wall = true;
    check(frob_create_stream_init(&stream, ids, 2, true), "a stream of two packets");
    check(receive(&stream, create_2, sizeof create_2, &sensors) == 1 && !sensors.virtual_wall,
          "the sum of a Create 2 has the header in it");
    check(receive(&stream, create_1, sizeof create_1, &sensors) == 0,
          "the sum of a Create 1 has not");
    frob_create_stream_init(&stream, ids, 2, false);
    check(receive(&stream, create_1, sizeof create_1, &sensors) == 1 && sensors.virtual_wall &&
              receive(&stream, create_2, sizeof create_2, &sensors) == 0,
          "a setting chooses");
}

/* Packets and their data, with a different value in each field. */
static const uint8_t body[] = {
    7,  0x09,                                /* bump right, drop left */
    9,  1,    11,   1,                       /* cliffs left and front right */
    28, 0x05, 0xDC, 31,   0x00, 0x2A,        /* signals of these two cliff sensors */
    13, 1,    14,   0x08, 17,   161,  18, 1, /* virtual wall, overcurrent, infrared, clean */
    21, 2,    22,   0x3A, 0x98,              /* charging, 15000 mV */
    25, 0x07, 0xD0, 26,   0x0A, 0x8C, 35, 2, /* 2000 of 2700 mAh, safe */
    43, 0xFF, 0xFE, 44,   0x00, 0x13, 23, 0xFE, 0xD4, /* counts; a packet without a field */
    46, 0x0F, 0xFF, 51,   0x00, 0x13,
};

static const uint8_t body_ids[] = { 7,  9,  11, 28, 31, 13, 14, 17, 18, 21,
                                    22, 25, 26, 35, 43, 44, 23, 46, 51 };

static size_t frame_of(const uint8_t *content, size_t count, uint8_t *frame)
{
    unsigned sum = 0;
    frame[0] = FROB_CREATE_HEADER;
    frame[1] = (uint8_t)count;
    memcpy(frame + 2, content, count);
    for (size_t i = 0; i < count + 2; i++)
        sum += frame[i];
    frame[count + 2] = (uint8_t)(0u - sum);
    return count + 3;
}

static void fields(void)
{
    struct frob_create_stream stream;
    struct frob_create_sensors s;
    uint8_t frame[FROB_CREATE_MAX_FRAME];
    size_t size = frame_of(body, sizeof body, frame);
    memset(&s, 0, sizeof s);
    check(frob_create_stream_init(&stream, body_ids, sizeof body_ids, true) &&
              stream.frame_size == size && receive(&stream, frame, size, &s) == 1,
          "a frame of nineteen packets");
    check(s.bump_right && !s.bump_left && !s.drop_right && s.drop_left, "bumps and wheel drops");
    check(s.cliff[0] && !s.cliff[1] && s.cliff[2] && !s.cliff[3], "cliffs");
    check(s.cliff_signal[0] == 1500 && s.cliff_signal[1] == 0 && s.cliff_signal[2] == 0 &&
              s.cliff_signal[3] == 42,
          "cliff signals");
    check(s.virtual_wall && s.overcurrent == 8 && s.infrared == 161 && s.buttons == 1,
          "wall, overcurrent, infrared, buttons");
    check(s.charging == 2 && s.battery_mv == 15000 && s.charge_mah == 2000 &&
              s.capacity_mah == 2700,
          "battery");
    check(s.mode == FROB_CREATE_MODE_SAFE, "mode");
    check(s.left_counts == 65534 && s.right_counts == 19, "encoder counts");
    check(s.light_signal[0] == 4095 && s.light_signal[5] == 19, "light bumpers");
}

static void steps(void)
{
    check(frob_create_count_step(65535, 1) == 2, "counts wrap forwards");
    check(frob_create_count_step(1, 65535) == -2, "counts wrap backwards");
    check(frob_create_count_step(0, 32767) == 32767 && frob_create_count_step(0, 32768) == -32768,
          "the longest steps");
}

static void refused_lists(void)
{
    static const uint8_t unknown[] = { 7, 59 };
    uint8_t too_many[FROB_CREATE_MAX_IDS + 1];
    struct frob_create_stream stream;
    for (size_t i = 0; i < sizeof too_many; i++)
        too_many[i] = 22;
    check(!frob_create_stream_init(&stream, unknown, 2, true) &&
              !frob_create_stream_init(&stream, unknown, 0, true) &&
              !frob_create_stream_init(&stream, too_many, sizeof too_many, true),
          "lists that cannot be streamed are refused");
    check(frob_create_stream_init(&stream, too_many, FROB_CREATE_MAX_IDS, true),
          "the longest list can be");
}

/* Garbage that often consists of typical frame bytes, then a frame, which must be found at its
 * last byte. */
static void garbage(void)
{
    uint64_t seed = 1;
    unsigned missed = 0, invented = 0;
    struct frob_create_stream stream;
    struct frob_create_sensors s;
    uint8_t frame[FROB_CREATE_MAX_FRAME];
    size_t size = frame_of(body, sizeof body, frame);
    frob_create_stream_init(&stream, body_ids, sizeof body_ids, true);
    for (int round = 0; round < 100000; round++) {
        for (unsigned n = random_below(&seed, 80); n > 0; n--) {
            uint64_t r = random_next(&seed);
            uint8_t byte = (r & 3) == 0 ? frame[(r >> 8) % 8] : (uint8_t)(r >> 16);
            invented += frob_create_stream_receive(&stream, byte, &s);
        }
        memset(&s, 0, sizeof s);
        invented += receive(&stream, frame, size - 1, &s);
        missed += !frob_create_stream_receive(&stream, frame[size - 1], &s) || s.right_counts != 19;
    }
    check(missed == 0, "a frame after any garbage is found with its last byte");
    check(invented == 0, "garbage is no frame");
}

/* Every single bit error and every lost byte of a frame must be detected. */
static void errors(void)
{
    struct frob_create_stream stream;
    struct frob_create_sensors s;
    uint8_t frame[FROB_CREATE_MAX_FRAME];
    size_t size = frame_of(body, sizeof body, frame);
    unsigned accepted = 0;
    for (size_t bit = 0; bit < 8 * size; bit++) {
        frob_create_stream_init(&stream, body_ids, sizeof body_ids, true);
        for (size_t i = 0; i < size; i++)
            accepted += frob_create_stream_receive(
                &stream, (uint8_t)(frame[i] ^ (i == bit / 8 ? 1u << bit % 8 : 0u)), &s);
    }
    for (size_t lost = 0; lost < size; lost++) {
        frob_create_stream_clear(&stream);
        for (size_t i = 0; i < size; i++)
            accepted += i != lost && frob_create_stream_receive(&stream, frame[i], &s);
    }
    check(accepted == 0, "a frame with a wrong bit or without a byte is no frame");
}

int main(void)
{
    commands();
    sizes();
    checksums();
    fields();
    steps();
    refused_lists();
    garbage();
    errors();
    return check_status();
}
