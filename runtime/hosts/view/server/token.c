#include "token.h"

#include <stdio.h>
#include <string.h>

bool token_make(char token[TOKEN_LENGTH + 1])
{
    unsigned char bytes[TOKEN_LENGTH / 2];
    FILE *random = fopen("/dev/urandom", "rb");
    bool ok = random != NULL && fread(bytes, 1, sizeof bytes, random) == sizeof bytes;
    if (random != NULL)
        fclose(random);
    for (size_t i = 0; ok && i < sizeof bytes; i++)
        snprintf(token + 2 * i, 3, "%02x", bytes[i]);
    return ok;
}

bool token_is(const char *token, const char *text)
{
    unsigned difference = 0;
    if (strlen(text) != TOKEN_LENGTH)
        return false;
    for (size_t i = 0; i < TOKEN_LENGTH; i++)
        difference |= (unsigned)(token[i] ^ text[i]);
    return difference == 0;
}
