/* Fuzzes the Create's frames: for any bytes, the receiver must find exactly the frames in them,
 * each at its last byte. */
#include "fuzz.h"
#include "random.h"

#include "drivers/create/stream.h"

#include <string.h>

static const uint8_t ids[] = { 7, 35, 22, 43, 44, 46 };
/* Header, N, six ids (two with one data byte, four with two), checksum. */
enum { SIZE = 2 + 6 + 2 + 8 + 1 };

size_t fuzz_frame(uint64_t *seed, uint8_t bytes[FUZZ_FRAME])
{
    unsigned sum = 0;
    size_t size = 2;
    bytes[0] = 19;
    bytes[1] = SIZE - 3;
    for (size_t i = 0; i < sizeof ids; i++) {
        bytes[size++] = ids[i];
        for (size_t k = frob_create_packet_size(ids[i]); k > 0; k--)
            bytes[size++] = (uint8_t)random_below(seed, 256);
    }
    for (size_t i = 0; i < size; i++)
        sum += bytes[i];
    bytes[size++] = (uint8_t)(0u - sum);
    return size;
}

static bool is_frame(const uint8_t *at)
{
    static const size_t places[] = { 2, 4, 6, 9, 12, 15 };
    unsigned sum = 0;
    if (at[0] != 19 || at[1] != SIZE - 3)
        return false;
    for (size_t i = 0; i < sizeof ids; i++)
        if (at[places[i]] != ids[i])
            return false;
    for (size_t i = 0; i < SIZE; i++)
        sum += at[i];
    return (sum & 0xFF) == 0;
}

void fuzz_check(const uint8_t *bytes, size_t count)
{
    struct frob_create_stream stream;
    struct frob_create_sensors sensors;
    memset(&sensors, 0, sizeof sensors);
    if (!frob_create_stream_init(&stream, ids, sizeof ids, true) || stream.frame_size != SIZE)
        fuzz_fail("the stream is not what is expected");
    for (size_t i = 0; i < count; i++) {
        const uint8_t *at = bytes + i + 1 - SIZE;
        bool found = frob_create_stream_receive(&stream, bytes[i], &sensors);
        if (found != (i + 1 >= SIZE && is_frame(at)))
            fuzz_fail("a frame is found where there is none, or missed");
        if (found && (sensors.mode != at[5] || sensors.bump_right != (at[3] & 1) ||
                      sensors.left_counts != (at[10] << 8 | at[11]) ||
                      sensors.light_signal[0] != (at[16] << 8 | at[17])))
            fuzz_fail("a frame is not what was sent");
    }
}
