#include "fuzz.h"

#include "random.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 15, ROOM = 16384 };

static uint64_t checked;

void fuzz_fail(const char *what)
{
    fprintf(stderr, "FAIL %s\n", what);
    abort();
}

/* Checks the bytes in a buffer of exactly their size, so that reads beyond its end are detected. */
static void check_exactly(const uint8_t *bytes, size_t count)
{
    static uint64_t budget;
    uint8_t *copy = (uint8_t *)malloc(count + 1);
    if (copy == NULL)
        abort();
    if (budget == 0) {
        const char *asked = getenv("FUZZ_BYTES");
        budget = asked == NULL ? UINT64_MAX : strtoull(asked, NULL, 10);
    }
    memcpy(copy, bytes, count);
    fuzz_check(copy, count);
    free(copy);
    checked += count;
    if (checked >= budget) {
        printf("%llu bytes\n", (unsigned long long)checked);
        fflush(stdout);
        _Exit(0);
    }
}

/* Passes a byte through a faulty line. */
static size_t garble(uint64_t *seed, unsigned rate, uint8_t byte, uint8_t *out)
{
    if (random_below(seed, rate) != 0) {
        out[0] = byte;
        return 1;
    }
    switch (random_below(seed, 4)) {
    case 0: out[0] = (uint8_t)(byte ^ 1u << random_below(seed, 8)); return 1;
    case 1: return 0;
    case 2: out[0] = out[1] = byte; return 2;
    default:
        out[0] = byte;
        out[1] = (uint8_t)random_below(seed, 256);
        return 2;
    }
}

/* Mixes the bytes with good frames, and garbles everything. */
static size_t mix(uint64_t *seed, const uint8_t *bytes, size_t count, uint8_t *out)
{
    uint8_t frame[FUZZ_FRAME];
    size_t size = 0, taken = 0;
    unsigned rate = 2u << random_below(seed, 10);
    while (size + 4 * FUZZ_FRAME < ROOM) {
        size_t length = fuzz_frame(seed, frame);
        for (unsigned n = random_below(seed, 64); n > 0 && taken < count; n--)
            size += garble(seed, rate, bytes[taken++], out + size);
        for (size_t i = 0; i < length; i++)
            size += garble(seed, rate, frame[i], out + size);
    }
    return size;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count)
{
    static uint8_t mixed[ROOM];
    uint64_t seed = count;
    check_exactly(bytes, count);
    for (size_t i = 0; i < count; i++)
        seed = seed * UINT64_C(6364136223846793005) + bytes[i] + 1;
    for (int round = 0; round < ROUNDS; round++)
        check_exactly(mixed, mix(&seed, bytes, count, mixed));
    return 0;
}
