/* <stdlib.h>, for frob-tcc: the part of the standard header that Frob needs. */
#ifndef FROB_TCC_STDLIB_H
#define FROB_TCC_STDLIB_H

#include <stddef.h>

#define EXIT_SUCCESS 0
#define EXIT_FAILURE 1

void *malloc(size_t size);
void *calloc(size_t count, size_t size);
void *realloc(void *memory, size_t size);
void free(void *memory);
void abort(void);
void exit(int status);
char *getenv(const char *name);
double strtod(const char *text, char **end);
float strtof(const char *text, char **end);
long strtol(const char *text, char **end, int base);
unsigned long strtoul(const char *text, char **end, int base);
long long strtoll(const char *text, char **end, int base);
unsigned long long strtoull(const char *text, char **end, int base);
int abs(int n);
long labs(long n);

#endif
