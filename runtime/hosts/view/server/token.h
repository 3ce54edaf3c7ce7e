/* token.h -- what a page must know to be answered: 128 random bits. */
#ifndef FROB_VIEW_TOKEN_H
#define FROB_VIEW_TOKEN_H

#include <stdbool.h>

#define TOKEN_LENGTH 32 /* hexadecimal digits */

/* A new one, from the operating system. False if it has none. */
bool token_make(char token[TOKEN_LENGTH + 1]);

/* Is this the token? Takes as long wherever they differ. */
bool token_is(const char *token, const char *text);

#endif
