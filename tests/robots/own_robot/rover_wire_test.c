/* Tests the Rover's lines: valid ones from its description, and invalid ones. */
#include "check.h"
#include "rover_wire.h"

#include <stdio.h>
#include <string.h>

/* The last answer in these bytes; garbage if no line ends. */
static struct rover_answer answer_of(const char *bytes, int *lines)
{
    struct rover_receiver receiver;
    struct rover_answer answer = { ROVER_GARBAGE, 0, 0 };
    memset(&receiver, 0, sizeof receiver);
    *lines = 0;
    for (const char *at = bytes; *at != '\0'; at++)
        *lines += rover_receive(&receiver, (uint8_t)*at, &answer) ? 1 : 0;
    return answer;
}

static void reads(const char *bytes, enum rover_kind kind, int32_t first, int32_t second)
{
    int lines;
    struct rover_answer a = answer_of(bytes, &lines);
    check(lines == 1 && a.kind == kind &&
              (kind == ROVER_GARBAGE || (a.first == first && a.second == second)),
          bytes);
}

static void writes(char letter, size_t count, int32_t first, int32_t second, const char *expected)
{
    int32_t numbers[2];
    struct rover_command command;
    numbers[0] = first;
    numbers[1] = second;
    command = rover_write(letter, count, numbers);
    check(command.count == strlen(expected) && memcmp(command.bytes, expected, command.count) == 0,
          expected);
}

int main(void)
{
    int lines;
    struct rover_answer a;
    reads("OK\r\n", ROVER_OK, 0, 0);
    reads("Invalid Command\r\n", ROVER_INVALID, 0, 0);
    reads("57600\r\n", ROVER_NUMBER, 57600, 0);
    reads("0\r\n", ROVER_NUMBER, 0, 0);
    reads("-120 4711\r\n", ROVER_PAIR, -120, 4711);
    reads("-2147483648 2147483647\r\n", ROVER_PAIR, INT32_MIN, INT32_MAX);
    reads("2147483648\r\n", ROVER_GARBAGE, 0, 0);
    reads("12  4\r\n", ROVER_GARBAGE, 0, 0);
    reads("12 4 \r\n", ROVER_GARBAGE, 0, 0);
    reads("012\r\n", ROVER_GARBAGE, 0, 0);
    reads("-0\r\n", ROVER_GARBAGE, 0, 0);
    reads("+1\r\n", ROVER_GARBAGE, 0, 0);
    reads("12\n", ROVER_GARBAGE, 0, 0);
    reads("1\r2\r\n", ROVER_GARBAGE, 0, 0);
    reads("\r\n", ROVER_GARBAGE, 0, 0);
    reads("OK\t\r\n", ROVER_GARBAGE, 0, 0);
    reads("123456789012345678901234567890123456789\r\n", ROVER_GARBAGE, 0, 0);
    a = answer_of("\xff\x80garbage 12 3\r\n12 3\r\n", &lines);
    check(lines == 2 && a.kind == ROVER_PAIR && a.first == 12 && a.second == 3,
          "a line after garbage");
    writes('b', 0, 0, 0, "b\r");
    writes('m', 2, -12, 7, "m -12 7\r");
    writes('m', 2, INT32_MIN, INT32_MAX, "m -2147483648 2147483647\r");
    writes('w', 1, 500, 0, "w 500\r");
    return check_status();
}
