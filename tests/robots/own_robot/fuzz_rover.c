/* Fuzzes the Rover's lines: for any bytes, the receiver must end a line at each line feed, and
 * read the same values from it as a slow reader. */
#include "fuzz.h"
#include "random.h"

#include "rover_wire.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int number(uint64_t *seed)
{
    return (int)((uint32_t)random_next(seed) >> random_below(seed, 32)) *
           (random_below(seed, 2) == 0 ? 1 : -1);
}

size_t fuzz_frame(uint64_t *seed, uint8_t bytes[FUZZ_FRAME])
{
    int count = 0;
    switch (random_below(seed, 4)) {
    case 0: count = snprintf((char *)bytes, FUZZ_FRAME, "OK\r\n"); break;
    case 1: count = snprintf((char *)bytes, FUZZ_FRAME, "%d\r\n", number(seed)); break;
    default: count = snprintf((char *)bytes, FUZZ_FRAME, "%d %d\r\n", number(seed), number(seed));
    }
    return (size_t)count;
}

/* A slow reader with the C library: a line is valid if the library writes the same text for the
 * numbers that it reads. */
static struct rover_answer slowly(const uint8_t *line, size_t count)
{
    struct rover_answer answer = { ROVER_GARBAGE, 0, 0 };
    char text[ROVER_LINE + 1], again[64];
    long long first, second;
    if (count == 0 || count > ROVER_LINE || line[count - 1] != '\r' ||
        memchr(line, 0, count) != NULL)
        return answer;
    memcpy(text, line, count - 1);
    text[count - 1] = '\0';
    if (strcmp(text, "OK") == 0)
        answer.kind = ROVER_OK;
    else if (strcmp(text, "Invalid Command") == 0)
        answer.kind = ROVER_INVALID;
    else if (sscanf(text, "%lld %lld", &first, &second) == 2) {
        snprintf(again, sizeof again, "%lld %lld", first, second);
        if (strcmp(again, text) == 0 && first >= INT32_MIN && first <= INT32_MAX &&
            second >= INT32_MIN && second <= INT32_MAX) {
            answer.kind = ROVER_PAIR;
            answer.first = (int32_t)first;
            answer.second = (int32_t)second;
        }
    } else if (sscanf(text, "%lld", &first) == 1) {
        snprintf(again, sizeof again, "%lld", first);
        if (strcmp(again, text) == 0 && first >= INT32_MIN && first <= INT32_MAX) {
            answer.kind = ROVER_NUMBER;
            answer.first = (int32_t)first;
        }
    }
    return answer;
}

void fuzz_check(const uint8_t *bytes, size_t count)
{
    struct rover_receiver receiver;
    struct rover_answer found = { ROVER_GARBAGE, 0, 0 };
    size_t line = 0;
    memset(&receiver, 0, sizeof receiver);
    for (size_t i = 0; i < count; i++) {
        if (rover_receive(&receiver, bytes[i], &found) != (bytes[i] == '\n'))
            fuzz_fail("a line does not end where it ends");
        if (bytes[i] != '\n')
            continue;
        struct rover_answer expected = slowly(bytes + line, i - line);
        if (found.kind != expected.kind ||
            (found.kind == ROVER_PAIR &&
             (found.first != expected.first || found.second != expected.second)) ||
            (found.kind == ROVER_NUMBER && found.first != expected.first))
            fuzz_fail("a line is not read as it stands");
        line = i + 1;
    }
}
