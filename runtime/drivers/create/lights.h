/* create/lights.h -- converts a program's output to commands for the lights and the sound of a
 * Create. Any number is allowed: values out of range are clamped. */
#ifndef FROB_DRIVERS_CREATE_LIGHTS_H
#define FROB_DRIVERS_CREATE_LIGHTS_H

#include <frob/create.h>

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Writes the LEDS command; returns its size, 4. */
size_t frob_create_lights(const struct frob_create_output *output, uint8_t *bytes);

/* Writes the commands that play the tone; returns their size. The robot can only play notes of the
 * chromatic scale, from 49 Hz up, for at most 4 s. */
size_t frob_create_tone(const struct frob_create_output *output, uint8_t *bytes);

#ifdef __cplusplus
}
#endif
#endif
