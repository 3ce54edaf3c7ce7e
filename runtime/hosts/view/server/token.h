/* token.h -- the secret that a page must present: 128 random bits. */
#ifndef FROB_VIEW_TOKEN_H
#define FROB_VIEW_TOKEN_H

#include <stdbool.h>

#define TOKEN_LENGTH 32 /* hexadecimal digits */

/* Creates a token with the operating system's random number generator. Returns false if that is not
 * available. */
bool token_make(char token[TOKEN_LENGTH + 1]);

/* Compares `text` with the token, in constant time. */
bool token_is(const char *token, const char *text);

#endif
