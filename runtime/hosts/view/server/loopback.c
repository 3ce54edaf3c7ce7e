#include "loopback.h"

#include <string.h>
#include <strings.h>

/* Accepts an empty string, or a colon and a number from 1 to 65535. */
static bool is_port(const char *text, size_t length)
{
    unsigned long port = 0;
    if (length == 0)
        return true;
    if (text[0] != ':' || length < 2 || length > 6)
        return false;
    for (size_t i = 1; i < length; i++) {
        if (text[i] < '0' || text[i] > '9')
            return false;
        port = 10 * port + (unsigned long)(text[i] - '0');
    }
    return port >= 1 && port <= 65535;
}

bool loopback_is_host(const char *text, size_t length)
{
    static const char *const names[] = { "localhost", "127.0.0.1", "[::1]" };
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        const size_t own = strlen(names[i]);
        if (length >= own && strncasecmp(text, names[i], own) == 0 &&
            is_port(text + own, length - own))
            return true;
    }
    return false;
}

bool loopback_is_origin(const char *text, size_t length)
{
    static const char scheme[] = "http://";
    const size_t own = sizeof scheme - 1;
    return length > own && strncasecmp(text, scheme, own) == 0 &&
           loopback_is_host(text + own, length - own);
}
