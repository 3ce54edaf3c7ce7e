#include "colour.h"

#include "clones.h"

#include <string.h>

static const double turn = 6.283185307179586;

/* The number of steps along one side of the colour hexagon. With 127 steps, a sum of three products
 * of a component and a byte fits in 16 bits. */
enum { STEPS = 127 };

/* Clamps x to low … high; returns low if x is NaN. */
static double within(double low, double high, double x)
{
    return !(x > low) ? low : x > high ? high : x;
}

/* Reduces an angle to the range from 0 to one turn. Returns 0 if the angle is NaN or too large to
 * reduce precisely. */
static double within_turn(double angle)
{
    double turns, rest;

    if (!(angle > -1e6 && angle < 1e6))
        return 0;
    turns = angle / turn;
    rest = turns - (double)(int32_t)turns;
    return (rest < 0 ? rest + 1 : rest) * turn;
}

/* Computes the pure colour of a hue, with components from 0 to STEPS. */
static void pure_colour(double hue, int32_t colour[3])
{
    const double side = within(0, 6, within_turn(hue) / turn * 6);
    const int32_t number = (int32_t)side;
    const int32_t part = (int32_t)((side - number) * (double)STEPS + 0.5);
    const int32_t around[6] = { STEPS, STEPS - part, 0, 0, part, STEPS };

    for (int32_t i = 0; i < 3; i++)
        colour[i] = around[(number + 6 - 2 * i) % 6];
}

/* Computes factors whose scalar product with a colour is positive if the colour's hue is within
 * half a turn after this hue, and 0 if it is this hue or the opposite one. */
static void side_of(double hue, int16_t factors[3])
{
    int32_t d[3];

    pure_colour(hue, d);
    factors[0] = (int16_t)(d[2] - d[1]);
    factors[1] = (int16_t)(d[0] - d[2]);
    factors[2] = (int16_t)(d[1] - d[0]);
}

/* Finds the smallest and the largest n from 0 to `all` with low <= n / all <= high. Returns false
 * if there is none. */
static bool steps_of(double low, double high, int32_t all, int16_t *least, int16_t *most)
{
    if (!(low <= high && low <= 1 && high >= 0))
        return false;
    /* The tolerance accounts for rounding: 0.4 * 255 is 102, but the double nearest to 0.4 is above
     * 0.4. */
    *most = (int16_t)(within(0, 1, high) * all + 1e-9);
    *least = (int16_t)(all - (int16_t)((1 - within(0, 1, low)) * all + 1e-9));
    return *least <= *most;
}

struct frob_colours frob_colours_of(const struct frob_colour_range *range)
{
    const double size = range->hueTo - range->hueFrom;
    struct frob_colours colours;

    memset(&colours, 0, sizeof colours);
    if (!steps_of(range->saturationFrom, range->saturationTo, 128, &colours.pale,
                  &colours.strong) ||
        !steps_of(range->valueFrom, range->valueTo, 255, &colours.dark, &colours.bright) ||
        !(size > -1e6 && size < 1e6)) {
        colours.dark = 256;
        return colours;
    }
    /* If all factors are 0, every hue matches. */
    if (size >= turn)
        return colours;
    side_of(range->hueFrom, colours.from);
    side_of(range->hueTo, colours.to);
    /* If the range started and ended at the same half-line, the opposite hue would also match, so
     * this moves the end of the range by one step. */
    if (memcmp(colours.from, colours.to, sizeof colours.from) == 0)
        side_of(range->hueTo + turn / (6 * STEPS), colours.to);
    for (int32_t i = 0; i < 3; i++)
        colours.to[i] = (int16_t)-colours.to[i];
    colours.wide = within_turn(size) > turn / 2 ? 1 : 0;
    return colours;
}

FROB_CLONES
static void match_colours(const uint8_t *FROB_APART pixels, int32_t count,
                          const struct frob_colours *colours, uint8_t *FROB_APART mask)
{
    const int16_t fr = colours->from[0], fg = colours->from[1], fb = colours->from[2];
    const int16_t tr = colours->to[0], tg = colours->to[1], tb = colours->to[2];
    const int16_t pale = colours->pale, strong = colours->strong;
    const int16_t dark = colours->dark, bright = colours->bright, wide = colours->wide;

    for (int32_t i = 0; i < count; i++) {
        const int16_t r = pixels[3 * i], g = pixels[3 * i + 1], b = pixels[3 * i + 2];
        const int16_t most = r > g ? r : g, least = r < g ? r : g;
        const int16_t value = most > b ? most : b;
        const int16_t chroma = (int16_t)(value - (least < b ? least : b));
        const int16_t parts = (int16_t)(chroma * 128);
        const int past = (int16_t)(fr * r + fg * g + fb * b) >= 0;
        const int before = (int16_t)(tr * r + tg * g + tb * b) >= 0;
        mask[i] =
            (uint8_t)(((past & before) | (wide & (past | before))) &
                      (parts >= (int16_t)(pale * value)) & (parts <= (int16_t)(strong * value)) &
                      (value >= dark) & (value <= bright));
    }
}

FROB_CLONES
static void match_greys(const uint8_t *FROB_APART pixels, int32_t count,
                        const struct frob_colours *colours, uint8_t *FROB_APART mask)
{
    const int16_t dark = colours->dark;
    const int16_t bright = colours->pale > 0 && colours->bright > 0 ? 0 : colours->bright;

    for (int32_t i = 0; i < count; i++)
        mask[i] = (uint8_t)((pixels[i] >= dark) & (pixels[i] <= bright));
}

void frob_match_row(const struct frob_image *image, int32_t y, int32_t left, int32_t right,
                    const struct frob_colours *colours, uint8_t *mask)
{
    const uint8_t *row = frob_image_row(image, y);
    const int32_t count = right - left;

    if (image->format == FROB_RGB8)
        match_colours(row + 3 * (ptrdiff_t)left, count, colours, mask);
    else if (image->format == FROB_GREY8)
        match_greys(row + left, count, colours, mask);
    else
        memset(mask, 0, (size_t)count);
}

bool frob_next_run(const uint8_t *mask, int32_t count, int32_t *start, int32_t *end)
{
    static const uint8_t none[8] = { 0 };
    int32_t i = *end;

    while (i + 8 <= count && memcmp(mask + i, none, 8) == 0)
        i += 8;
    while (i < count && mask[i] == 0)
        i++;
    *start = i;
    while (i < count && mask[i] != 0)
        i++;
    *end = i;
    return *start < i;
}
