/* create/lights.h -- the lights and the sound of a Create, from what a program
 * wants. Any number will do: what is out of range is brought into it. */
#ifndef FROB_DRIVERS_CREATE_LIGHTS_H
#define FROB_DRIVERS_CREATE_LIGHTS_H

#include <frob/create.h>

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The command LEDS; gives its size, 4. */
size_t frob_create_lights(const struct frob_create_output *output, uint8_t *bytes);

/* The commands that play the tone; gives their size. The robot has the notes
 * of the scale from 49 Hz, and tones up to 4 s. */
size_t frob_create_tone(const struct frob_create_output *output, uint8_t *bytes);

#ifdef __cplusplus
}
#endif
#endif
