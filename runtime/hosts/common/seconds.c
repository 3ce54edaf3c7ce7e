#include "seconds.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool seconds_read(const char *text, int64_t *result)
{
    char decimal[64];
    const uint64_t limit = UINT64_C(1000000000000000000); /* 10^9 s */
    uint64_t ns = 0;
    bool negative = *text == '-', digits = false;
    int places = 0;
    if (strpbrk(text, "eE") != NULL) { /* such as 1e-05: as a plain decimal */
        char *end;
        double seconds = strtod(text, &end);
        if (*end != '\0' || !(seconds > -1e9 && seconds < 1e9))
            return false;
        snprintf(decimal, sizeof decimal, "%.12f", seconds);
        text = decimal;
        negative = *text == '-';
    }
    if (*text == '-' || *text == '+')
        text++;
    for (; *text >= '0' && *text <= '9'; text++) {
        ns = ns * 10 + (uint64_t)(*text - '0');
        digits = true;
        if (ns > limit / 1000000000u)
            return false;
    }
    if (*text == '.') {
        for (text++; *text >= '0' && *text <= '9'; text++) {
            digits = true;
            if (places < 9) {
                ns = ns * 10 + (uint64_t)(*text - '0');
                places++;
            } else if (places == 9) {
                ns += *text >= '5';
                places++;
            }
        }
    }
    if (!digits)
        return false;
    for (; places < 9; places++)
        ns *= 10;
    if (*text != '\0')
        return false;
    *result = negative ? -(int64_t)ns : (int64_t)ns;
    return true;
}
