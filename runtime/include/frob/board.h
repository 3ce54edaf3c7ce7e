/* frob/board.h -- the simulated end of the line of a robot of the user's own, for
 * `frobc serve`: what the robot's own computer does with the bytes that come.
 *
 * A board is a constant table in a C file that is given with `--with`, beside the
 * body (<frob/body.h>): the robot `rover` has
 *
 *   const struct frob_board frob_rover_board = { … };
 *
 * Write it from the protocol's description and not from the driver, so that each
 * judges the other. Nothing waits, and time is what it is told. */
#ifndef FROB_BOARD_H
#define FROB_BOARD_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What goes back over the line; who calls the board takes it. */
struct frob_answer {
    uint8_t bytes[512];
    size_t count;
};

struct frob_board {
    const char *robot; /* "rover", as in struct frob_program */
    uint32_t rate;     /* of the line, bits per second */
    size_t size;       /* of the board's memory, all zero when it is turned on */

    /* What the body senses from `now_ns` on, as the robot's input struct. An event is in it once. */
    void (*sense)(void *board, const void *input, int64_t now_ns);

    /* A byte has come; it is still the time of the last `sense` or `advance`. */
    void (*receive)(void *board, uint8_t byte, struct frob_answer *answer);

    /* Lets watchdogs, and answers that take their time, look at the time. */
    void (*advance)(void *board, int64_t now_ns, struct frob_answer *answer);

    /* What the body shall do now: fills in the robot's output struct, all zero before. */
    void (*drive)(const void *board, void *output);
};

#ifdef __cplusplus
}
#endif
#endif
