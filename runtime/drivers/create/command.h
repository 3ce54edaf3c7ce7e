/* create/command.h -- the commands that the driver sends to a Create 2.
 *
 * A command is an opcode and its data, without a frame or checksum. It must be sent completely,
 * because a lost byte shifts everything after it. Numbers are two's complement, high byte first.
 * Each function writes a command and returns its size.
 *
 * Sources: libcreate (AutonomyLab), pycreate2, and the manual of the Create 1 where those agree
 * with it. */
#ifndef FROB_CREATE_COMMAND_H
#define FROB_CREATE_COMMAND_H

#include <stddef.h>
#include <stdint.h>

#include "drivers/steps.h"

#ifdef __cplusplus
extern "C" {
#endif

enum frob_create_opcode {
    FROB_CREATE_START = 128, /* changes from any mode to Passive */
    FROB_CREATE_SAFE = 131,
    FROB_CREATE_FULL = 132,
    FROB_CREATE_LEDS = 139,
    FROB_CREATE_SONG = 140,
    FROB_CREATE_PLAY = 141,
    FROB_CREATE_DRIVE_DIRECT = 145,
    FROB_CREATE_STREAM = 148,
    FROB_CREATE_PAUSE_STREAM = 150
};

enum {
    FROB_CREATE_MAX_SPEED_MM_S = 500, /* speed of a wheel */
    FROB_CREATE_MAX_COMMAND = 54      /* size in bytes of a STREAM command that requests every
                                       * single packet */
};

/* START, SAFE, FULL, ...: commands without data. */
size_t frob_create_plain(enum frob_create_opcode opcode, uint8_t *bytes);

/* Range and resolution of DRIVE_DIRECT: mm/s for each wheel. */
static inline struct frob_wire frob_create_wire(double separation_m)
{
    struct frob_wire wire = { true,
                              { 1e-3, 1e-3 },
                              { (double)FROB_CREATE_MAX_SPEED_MM_S * 1e-3,
                                (double)FROB_CREATE_MAX_SPEED_MM_S * 1e-3 },
                              separation_m };
    return wire;
}

/* DRIVE_DIRECT: wheel speeds, mm/s, limited to FROB_CREATE_MAX_SPEED_MM_S. The
 * right wheel is first on the wire. */
size_t frob_create_drive_direct(int right_mm_s, int left_mm_s, uint8_t *bytes);

/* STREAM: a frame of these packets every 15 ms; count is at most
 * FROB_CREATE_MAX_IDS. */
size_t frob_create_stream_request(const uint8_t *ids, size_t count, uint8_t *bytes);

/* PAUSE_STREAM. */
size_t frob_create_stream_pause(uint8_t *bytes);

/* LEDS: the small lights (bit 0 debris, 1 spot, 2 dock, 3 check), and the colour (0 green, 255 red)
 * and brightness of the light around the Clean button. */
size_t frob_create_leds(unsigned lights, unsigned colour, unsigned brightness, uint8_t *bytes);

/* SONG and PLAY: one note, given by its MIDI number (69 is 440 Hz; 31 to 127) and its duration in
 * 1/64 s (1 to 255). */
size_t frob_create_note(unsigned note, unsigned duration, uint8_t *bytes);

#ifdef __cplusplus
}
#endif
#endif
