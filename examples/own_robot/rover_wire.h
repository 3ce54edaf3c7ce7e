/* rover_wire.h -- a Rover's lines: text to numbers and back.
 *
 * The protocol has the form of ROSArduinoBridge's, a widespread firmware for
 * boards of this kind: 57600 bits per second, one letter and its numbers, ended
 * by a carriage return; each command is answered by one line, ended by a
 * carriage return and a line feed.
 *
 *   b        the rate of the line                         57600
 *   e        counts of the left and of the right encoder  -120 4711
 *   m L R    speeds, counts in 1/30 s                     OK
 *   p N      asks ranger N, 0 to 4: cm, 0 for no echo     153
 *   a 0      the battery, 0 to 1023 of 15 V               839
 *   w MS     stops after so long without an m             OK
 *
 * What the board does not know it answers with "Invalid Command". There is no
 * check sum, and an answer does not say what it answers. */
#ifndef ROVER_WIRE_H
#define ROVER_WIRE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { ROVER_RATE = 57600, ROVER_LOOPS = 30, ROVER_SONARS = 5, ROVER_LINE = 32 };

enum rover_kind {
    ROVER_OK,
    ROVER_INVALID, /* the board does not know the command */
    ROVER_NUMBER,
    ROVER_PAIR,
    ROVER_GARBAGE /* a line that is none of these */
};

struct rover_answer {
    enum rover_kind kind;
    int32_t first, second;
};

/* What has come of a line. All zero at the start. */
struct rover_receiver {
    char text[ROVER_LINE];
    size_t count;
    bool spoiled; /* too long, or not text */
};

/* Takes a byte; true if it ends a line. After garbage the next line but one is
 * read as it was sent: the first may have begun in the garbage. */
bool rover_receive(struct rover_receiver *receiver, uint8_t byte, struct rover_answer *answer);

/* A line with a letter and numbers, as they are sent. */
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
