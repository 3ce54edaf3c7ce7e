#include "unit.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

/* The units of stdlib/Prelude.frob. */
static const struct {
    const char *name;
    double scale;
} units[] = {
    { "m", 1 },
    { "kg", 1 },
    { "s", 1 },
    { "A", 1 },
    { "K", 1 },
    { "mol", 1 },
    { "cd", 1 },
    { "mm", 0.001 },
    { "cm", 0.01 },
    { "km", 1000 },
    { "us", 0.000001 },
    { "ms", 0.001 },
    { "min", 60 },
    { "hour", 3600 },
    { "g", 0.001 },
    { "Hz", 1 },
    { "N", 1 },
    { "J", 1 },
    { "W", 1 },
    { "V", 1 },
    { "Ohm", 1 },
    { "Pa", 1 },
    { "rad", 1 },
    { "deg", 3.14159265358979323846 / 180 },
    { "rpm", 3.14159265358979323846 / 30 },
};

static bool scale_of(const char *name, size_t length, double *scale)
{
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++)
        if (strlen(units[i].name) == length && memcmp(units[i].name, name, length) == 0) {
            *scale = units[i].scale;
            return true;
        }
    return false;
}

/* Adjacent factors are multiplied; a slash divides by the factor after it. */
bool unit_read(const char *text, size_t length, double *scale)
{
    size_t i = 0;
    *scale = 1;
    while (i < length) {
        size_t start;
        double factor = 1, exponent = 1;
        bool divides = text[i] == '/';
        i += divides ? 1 : 0;
        while (i < length && text[i] == ' ')
            i++;
        start = i;
        while (i < length && isalpha((unsigned char)text[i]))
            i++;
        if (i == start && i < length && text[i] == '1')
            i++; /* for example in 1/s */
        else if (!scale_of(text + start, i - start, &factor))
            return false;
        if (i < length && text[i] == '^') {
            bool negative = i + 1 < length && text[i + 1] == '-';
            i += negative ? 2 : 1;
            if (i == length || !isdigit((unsigned char)text[i]))
                return false;
            exponent = (negative ? -1 : 1) * (text[i++] - '0');
        }
        *scale *= pow(factor, divides ? -exponent : exponent);
        while (i < length && text[i] == ' ')
            i++;
    }
    return length > 0;
}
