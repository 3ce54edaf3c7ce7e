#include "answer.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

bool address_read(struct address *address, const char *text)
{
    size_t length, digits;
    memset(address, 0, sizeof *address);
    if (strncmp(text, "http://", 7) != 0)
        return false;
    text += 7;
    if (*text == '[') {
        length = strcspn(++text, "]");
        if (text[length] != ']' || length >= sizeof address->host)
            return false;
        memcpy(address->host, text, length);
        text += length + 1;
    } else {
        length = strcspn(text, ":/@");
        if (length >= sizeof address->host)
            return false;
        memcpy(address->host, text, length);
        text += length;
    }
    snprintf(address->port, sizeof address->port, "80");
    if (*text == ':') {
        digits = strspn(++text, "0123456789");
        if (digits == 0 || digits > 5)
            return false;
        memcpy(address->port, text, digits);
        address->port[digits] = '\0';
        text += digits;
    }
    address->path = text;
    return address->host[0] != '\0' && (*text == '\0' || *text == '/') &&
           strpbrk(text, " \r\n") == NULL;
}

/* Returns the value of the header on this line if it has this name, otherwise
 * NULL. */
static const char *value_of(const char *line, size_t length, const char *name, size_t *rest)
{
    const size_t named = strlen(name);
    if (length < named + 1 || strncasecmp(line, name, named) != 0 || line[named] != ':')
        return NULL;
    line += named + 1;
    length -= named + 1;
    while (length > 0 && (*line == ' ' || *line == '\t')) {
        line++;
        length--;
    }
    *rest = length;
    return line;
}

static void read_header(struct answer *answer, const char *line, size_t length)
{
    size_t rest = 0;
    const char *value = value_of(line, length, "Content-Type", &rest);
    if (value != NULL) {
        size_t n = 0;
        while (n < rest && n + 1 < sizeof answer->type && value[n] > ' ' && value[n] < 0x7F &&
               value[n] != ';') {
            answer->type[n] = (char)(value[n] >= 'A' && value[n] <= 'Z' ? value[n] + 32 : value[n]);
            n++;
        }
        answer->type[n] = '\0';
        return;
    }
    value = value_of(line, length, "Transfer-Encoding", &rest);
    if (value != NULL && rest >= 7 && strncasecmp(value, "chunked", 7) == 0)
        answer->is_chunked = true;
}

/* HTTP/1.1 200 OK */
static bool read_status(struct answer *answer, const char *line, size_t length)
{
    if (length < 12 || memcmp(line, "HTTP/1.", 7) != 0 || line[8] != ' ')
        return false;
    for (size_t i = 9; i < 12; i++) {
        if (line[i] < '0' || line[i] > '9')
            return false;
        answer->status = 10 * answer->status + (line[i] - '0');
    }
    return true;
}

enum answer_result answer_read(struct answer *answer, const char *bytes, size_t size,
                               size_t *length)
{
    size_t at = 0;
    memset(answer, 0, sizeof *answer);
    if (memcmp(bytes, "HTTP/1.", size < 7 ? size : 7) != 0)
        return ANSWER_WRONG;
    for (;;) {
        const char *feed = at < size ? (const char *)memchr(bytes + at, '\n', size - at) : NULL;
        size_t line;
        if (feed == NULL)
            return size < ANSWER_ROOM ? ANSWER_MORE : ANSWER_WRONG;
        line = (size_t)(feed - bytes) - at;
        if (line > 0 && bytes[at + line - 1] == '\r')
            line--;
        if (at == 0) {
            if (!read_status(answer, bytes, line))
                return ANSWER_WRONG;
        } else if (line == 0) {
            *length = (size_t)(feed - bytes) + 1;
            return ANSWER_GOOD;
        } else {
            read_header(answer, bytes + at, line);
        }
        at = (size_t)(feed - bytes) + 1;
    }
}
