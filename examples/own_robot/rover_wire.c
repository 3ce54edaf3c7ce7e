#include "rover_wire.h"

#include <string.h>

/* Reads a number as the board writes it: no whitespace, no plus sign, no leading zero. Returns the
 * text after the number, or NULL if there is no number at `text`. */
static const char *read_number(const char *text, int32_t *number)
{
    bool negative = *text == '-';
    int64_t value = 0;
    if (negative)
        text++;
    if (*text < '0' || *text > '9' ||
        (*text == '0' && (negative || (text[1] >= '0' && text[1] <= '9'))))
        return NULL;
    for (; *text >= '0' && *text <= '9'; text++) {
        value = 10 * value + (*text - '0');
        if (value > INT64_C(2147483648))
            return NULL;
    }
    if (negative)
        value = -value;
    if (value > INT32_MAX)
        return NULL;
    *number = (int32_t)value;
    return text;
}

static struct rover_answer read_line(const char *text)
{
    struct rover_answer answer = { ROVER_GARBAGE, 0, 0 };
    const char *rest;
    if (strcmp(text, "OK") == 0)
        answer.kind = ROVER_OK;
    else if (strcmp(text, "Invalid Command") == 0)
        answer.kind = ROVER_INVALID;
    else if ((rest = read_number(text, &answer.first)) == NULL)
        return answer;
    else if (*rest == '\0')
        answer.kind = ROVER_NUMBER;
    else if (*rest == ' ' && (rest = read_number(rest + 1, &answer.second)) != NULL &&
             *rest == '\0')
        answer.kind = ROVER_PAIR;
    return answer;
}

/* A carriage return is valid only before the line feed. */
bool rover_receive(struct rover_receiver *r, uint8_t byte, struct rover_answer *answer)
{
    bool ended = r->count > 0 && r->text[r->count - 1] == '\r';
    if (byte != '\n') {
        if (ended || r->count == sizeof r->text || (byte != '\r' && (byte < ' ' || byte > '~')))
            r->spoiled = true;
        else
            r->text[r->count++] = (char)byte;
        return false;
    }
    answer->kind = ROVER_GARBAGE;
    if (ended && !r->spoiled) {
        r->text[r->count - 1] = '\0';
        *answer = read_line(r->text);
    }
    r->count = 0;
    r->spoiled = false;
    return true;
}

static void put(struct rover_command *command, char c)
{
    command->bytes[command->count++] = (uint8_t)c;
}

static void put_number(struct rover_command *command, int32_t number)
{
    char digits[10];
    size_t count = 0;
    uint32_t rest = number < 0 ? 0u - (uint32_t)number : (uint32_t)number;
    if (number < 0)
        put(command, '-');
    do {
        digits[count++] = (char)('0' + rest % 10);
        rest /= 10;
    } while (rest > 0);
    while (count > 0)
        put(command, digits[--count]);
}

struct rover_command rover_write(char letter, size_t count, const int32_t *numbers)
{
    struct rover_command command;
    command.count = 0;
    put(&command, letter);
    for (size_t i = 0; i < count; i++) {
        put(&command, ' ');
        put_number(&command, numbers[i]);
    }
    put(&command, '\r');
    return command;
}
