/* frob/board.h -- the interface for simulating the robot's end of the serial line for a
 * user-defined robot. `frobc serve` uses it to determine how the robot's own computer reacts to the
 * bytes that it receives.
 *
 * A board is a constant table in a C file passed with `--with`, next to the body (<frob/body.h>).
 * For the robot `rover` it is
 *
 *   const struct frob_board frob_rover_board = { … };
 *
 * Write it from the specification of the protocol, not from the driver, so that the board and the
 * driver check each other. The functions must not block; the simulation passes them the time. */
#ifndef FROB_BOARD_H
#define FROB_BOARD_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Bytes that the board sends during a call; empty before the call. */
struct frob_answer {
    uint8_t bytes[512];
    size_t count;
};

struct frob_board {
    const char *robot; /* "rover", as in struct frob_program */
    uint32_t rate;     /* bit rate of the line */
    size_t size;       /* size in bytes of the board's memory, which is all zero at power-on */

    /* Passes the body's sensor readings at the time `now_ns` to the board, as the robot's input
     * struct. Each event is passed once. */
    void (*sense)(void *board, const void *input, int64_t now_ns);

    /* Handles a byte that was received at the time passed to the last call of `sense` or
     * `advance`. */
    void (*receive)(void *board, uint8_t byte, struct frob_answer *answer);

    /* Advances the time, for watchdogs and delayed answers. */
    void (*advance)(void *board, int64_t now_ns, struct frob_answer *answer);

    /* Stores the current command for the body in the robot's output struct, which is all zero
     * before the call. */
    void (*drive)(const void *board, void *output);
};

#ifdef __cplusplus
}
#endif
#endif
