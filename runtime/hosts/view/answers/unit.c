#include "unit.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

/* The units of stdlib/Prelude.frob, each as a product of base units. */
static const struct {
    const char *name;
    double scale;
    const char *base;
} units[] = {
    { "m", 1, "" },
    { "kg", 1, "" },
    { "s", 1, "" },
    { "A", 1, "" },
    { "K", 1, "" },
    { "mol", 1, "" },
    { "cd", 1, "" },
    { "mm", 0.001, "m" },
    { "cm", 0.01, "m" },
    { "km", 1000, "m" },
    { "us", 0.000001, "s" },
    { "ms", 0.001, "s" },
    { "min", 60, "s" },
    { "hour", 3600, "s" },
    { "g", 0.001, "kg" },
    { "Hz", 1, "1/s" },
    { "N", 1, "kg m/s^2" },
    { "J", 1, "kg m^2/s^2" },
    { "W", 1, "kg m^2/s^3" },
    { "V", 1, "kg m^2/s^3/A" },
    { "Ohm", 1, "kg m^2/s^3/A^2" },
    { "Pa", 1, "kg/m/s^2" },
    { "rad", 1, "1" },
    { "deg", 3.14159265358979323846 / 180, "1" },
    { "rpm", 3.14159265358979323846 / 30, "1/s" },
};

/* Multiplies a dimension by a power of a base unit. */
static void multiply(struct dimension *d, const char *name, size_t length, double power)
{
    size_t i = 0;
    while (i < d->count &&
           (strlen(d->factors[i].name) != length || memcmp(d->factors[i].name, name, length) != 0))
        i++;
    if (i == d->count) {
        if (i == UNIT_FACTORS || length >= sizeof d->factors[i].name) {
            d->is_open = true;
            return;
        }
        memcpy(d->factors[i].name, name, length);
        d->factors[i].name[length] = '\0';
        d->factors[i].power = 0;
        d->count++;
    }
    d->factors[i].power += power;
    if (d->factors[i].power == 0)
        d->factors[i] = d->factors[--d->count];
}

/* Multiplies a dimension and its scale by a power of a unit. */
static bool apply(struct dimension *d, double *scale, const char *name, size_t length, double power,
                  bool takes_any)
{
    for (size_t i = 0; i < sizeof units / sizeof units[0]; i++) {
        struct dimension base;
        double unused;
        if (strlen(units[i].name) != length || memcmp(units[i].name, name, length) != 0)
            continue;
        *scale *= pow(units[i].scale, power);
        if (units[i].base[0] == '\0') {
            multiply(d, name, length, power);
        } else {
            unit_read(units[i].base, strlen(units[i].base), false, &base, &unused);
            *d = dimension_product(d, &base, power);
        }
        return true;
    }
    if (takes_any)
        multiply(d, name, length, power);
    return takes_any;
}

static bool is_of_name(char c)
{
    return isalnum((unsigned char)c) || c == '_' || c == '\'' || (unsigned char)c >= 0x80;
}

/* Adjacent factors are multiplied; a slash divides by the factor after it. */
bool unit_read(const char *text, size_t length, bool takes_any, struct dimension *dimension,
               double *scale)
{
    size_t i = 0;
    memset(dimension, 0, sizeof *dimension);
    *scale = 1;
    while (i < length) {
        size_t start, end;
        double exponent = 1;
        const bool divides = text[i] == '/';
        i += divides ? 1 : 0;
        while (i < length && text[i] == ' ')
            i++;
        start = i;
        if (i < length && !isdigit((unsigned char)text[i]))
            while (i < length && is_of_name(text[i]))
                i++;
        end = i;
        if (end == start && i < length && text[i] == '1')
            i++; /* as in 1/s */
        if (i < length && text[i] == '^') {
            const bool negative = i + 1 < length && text[i + 1] == '-';
            i += negative ? 2 : 1;
            if (i == length || !isdigit((unsigned char)text[i]))
                return false;
            exponent = (negative ? -1 : 1) * (text[i++] - '0');
        }
        if (i == start || (end > start && !apply(dimension, scale, text + start, end - start,
                                                 divides ? -exponent : exponent, takes_any)))
            return false;
        while (i < length && text[i] == ' ')
            i++;
    }
    return length > 0;
}

struct dimension dimension_product(const struct dimension *a, const struct dimension *b,
                                   double power_of_b)
{
    struct dimension product = *a;
    product.is_open = a->is_open || b->is_open;
    for (size_t i = 0; i < b->count; i++)
        multiply(&product, b->factors[i].name, strlen(b->factors[i].name),
                 b->factors[i].power * power_of_b);
    return product;
}

bool dimensions_match(const struct dimension *a, const struct dimension *b)
{
    const struct dimension quotient = dimension_product(a, b, -1);
    return quotient.is_open || quotient.count == 0;
}

static void write_factors(const struct dimension *dimension, bool are_below, struct buffer *text)
{
    const char *between = are_below ? "/" : "";
    for (size_t i = 0; i < dimension->count; i++) {
        const double power = dimension->factors[i].power * (are_below ? -1 : 1);
        if (power <= 0)
            continue;
        buffer_format(text, "%s%s", between, dimension->factors[i].name);
        if (power != 1)
            buffer_format(text, "^%g", power);
        between = are_below ? "/" : " ";
    }
}

void dimension_write(const struct dimension *dimension, struct buffer *text)
{
    bool has_above = false;
    if (dimension->count == 0) {
        buffer_text(text, "a plain number");
        return;
    }
    for (size_t i = 0; i < dimension->count; i++)
        has_above |= dimension->factors[i].power > 0;
    if (!has_above)
        buffer_text(text, "1");
    write_factors(dimension, false, text);
    write_factors(dimension, true, text);
}
