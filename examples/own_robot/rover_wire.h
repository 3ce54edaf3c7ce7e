/* rover_wire.h -- a Rover's protocol: converts lines to numbers and back.
 *
 * The protocol is based on that of ROSArduinoBridge, a widespread firmware for boards of this kind.
 * The line runs at 57600 bits per second. A command consists of one letter and its numbers, and
 * ends with a carriage return. The board answers each command with one line, which ends with a
 * carriage return and a line feed.
 *
 *   b        rate of the line                            57600
 *   e        counts of the left and right encoder        -120 4711
 *   m L R    speeds, counts per 1/30 s                   OK
 *   p N      queries ranger N, 0 to 4: cm, 0 for no echo 153
 *   a 0      battery, 0 to 1023 for 0 to 15 V            839
 *   w MS     stop after this time without an m           OK
 *
 * The board answers unknown commands with "Invalid Command". There is no checksum, and an answer
 * does not say which command it belongs to. */
#ifndef ROVER_WIRE_H
#define ROVER_WIRE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { ROVER_RATE = 57600, ROVER_LOOPS = 30, ROVER_SONARS = 5, ROVER_LINE = 32 };

/* Encoder counts per metre of travel. */
#define ROVER_COUNTS_A_METRE 8000.0

enum rover_kind {
    ROVER_OK,
    ROVER_INVALID, /* the board does not know the command */
    ROVER_NUMBER,
    ROVER_PAIR,
    ROVER_GARBAGE /* a line of any other form */
};

struct rover_answer {
    enum rover_kind kind;
    int32_t first, second;
};

/* The part of a line received so far. Initialize with zeros. */
struct rover_receiver {
    char text[ROVER_LINE];
    size_t count;
    bool spoiled; /* whether the line is too long or has an invalid byte */
};

/* Processes a byte. Returns true if the byte ends a line. After garbage, the next line may be
 * invalid too, because it may have begun within the garbage; the line after it is read
 * correctly. */
bool rover_receive(struct rover_receiver *receiver, uint8_t byte, struct rover_answer *answer);

/* A line with a letter and its numbers, ready to be sent. */
struct rover_command {
    uint8_t bytes[ROVER_LINE];
    size_t count;
};

/* `count` is the number of `numbers`, 0 to 2. */
struct rover_command rover_write(char letter, size_t count, const int32_t *numbers);

#ifdef __cplusplus
}
#endif
#endif
