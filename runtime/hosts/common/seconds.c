#include "seconds.h"

#include <stdlib.h>
#include <string.h>

#define NS_PLACES 9

/* Returns the number of digits before the decimal point, or -1 if there are no digits. Stores
 * the position after the last digit in `end`. */
static long digits(const char *text, const char **end)
{
    const char *at = text;
    long whole = 0, decimals = 0;
    for (; *at >= '0' && *at <= '9'; at++)
        whole++;
    if (*at == '.')
        for (at++; *at >= '0' && *at <= '9'; at++)
            decimals++;
    *end = at;
    return whole + decimals == 0 ? -1 : whole;
}

/* Reads an optional exponent, as in 1e-05, and clamps it, because any larger exponent is out of
 * range. Returns false if the text contains anything else. */
static bool exponent(const char *text, long *result)
{
    char *end;
    *result = 0;
    if (*text == '\0')
        return true;
    if (*text != 'e' && *text != 'E')
        return false;
    text++;
    if (!((*text >= '0' && *text <= '9') ||
          ((*text == '-' || *text == '+') && text[1] >= '0' && text[1] <= '9')))
        return false;
    *result = strtol(text, &end, 10);
    *result = *result > 1000000 ? 1000000 : *result < -1000000 ? -1000000 : *result;
    return *end == '\0';
}

bool seconds_read(const char *text, int64_t *result)
{
    const bool negative = *text == '-';
    const char *start = *text == '-' || *text == '+' ? text + 1 : text, *end;
    const long whole = digits(start, &end);
    const uint64_t limit = (uint64_t)MOST_SECONDS * 1000000000u;
    uint64_t ns = 0;
    long place, raised; /* place: decimal exponent of the next digit */
    if (whole < 0 || !exponent(end, &raised))
        return false;
    place = whole + raised - 1;
    for (const char *at = start; at < end && place >= -NS_PLACES - 1; at++) {
        if (*at == '.')
            continue;
        if (place < -NS_PLACES)
            ns += *at >= '5';
        else if (ns > limit / 10)
            return false;
        else
            ns = ns * 10 + (uint64_t)(*at - '0');
        place--;
    }
    if (ns == 0)
        place = -NS_PLACES - 1;
    for (; place >= -NS_PLACES; place--) {
        if (ns > limit / 10)
            return false;
        ns *= 10;
    }
    if (ns > limit)
        return false;
    *result = negative ? -(int64_t)ns : (int64_t)ns;
    return true;
}

/* Detects times since 1970 in units smaller than seconds; the current time is about 1.8e9 s. */
const char *seconds_too_far(const char *text)
{
    const double seconds = strtod(text, NULL);
    const double size = seconds < 0.0 ? -seconds : seconds;
    if (text[strspn(text, "0123456789.+-eE")] != '\0' || !(size > (double)MOST_SECONDS))
        return "";
    if (size > 1e11 && size < 1e14)
        return "; the maximum is 4000000000 s: this looks like milliseconds, so divide the "
               "times by 1e3";
    if (size >= 1e14 && size < 1e17)
        return "; the maximum is 4000000000 s: this looks like microseconds, so divide the "
               "times by 1e6";
    if (size >= 1e17 && size < 1e20)
        return "; the maximum is 4000000000 s: this looks like nanoseconds, so divide the "
               "times by 1e9";
    return "; the maximum is 4000000000 s";
}
