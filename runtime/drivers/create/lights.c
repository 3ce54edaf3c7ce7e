#include "drivers/create/lights.h"

#include "drivers/create/command.h"

#include <math.h>

/* Rounds a value and clamps it to the range; converts NaN to the minimum. */
static unsigned within(double value, unsigned least, unsigned greatest)
{
    if (!(value > least))
        return least;
    return value >= greatest ? greatest : (unsigned)lround(value);
}

size_t frob_create_lights(const struct frob_create_output *output, uint8_t *bytes)
{
    unsigned lights = (unsigned)output->debrisLight | (unsigned)output->spotLight << 1 |
                      (unsigned)output->dockLight << 2 | (unsigned)output->checkLight << 3;
    return frob_create_leds(lights, within(255.0 * output->powerColour, 0, 255),
                            within(255.0 * output->powerLight, 0, 255), bytes);
}

size_t frob_create_tone(const struct frob_create_output *output, uint8_t *bytes)
{
    /* If the frequency is not above 0, the note is NaN or -inf, and the lowest note is played. */
    double note = 69.0 + 12.0 * log2(output->tone.f0 / 440.0);
    return frob_create_note(within(note, 31, 127), within(64.0 * output->tone.f1, 1, 255), bytes);
}
