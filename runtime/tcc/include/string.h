/* <string.h>, for frob-tcc: the part of the standard header that Frob needs. */
#ifndef FROB_TCC_STRING_H
#define FROB_TCC_STRING_H

#include <stddef.h>

void *memcpy(void *to, const void *from, size_t size);
void *memmove(void *to, const void *from, size_t size);
void *memset(void *to, int byte, size_t size);
int memcmp(const void *a, const void *b, size_t size);
void *memchr(const void *in, int byte, size_t size);
size_t strlen(const char *text);
int strcmp(const char *a, const char *b);
int strncmp(const char *a, const char *b, size_t size);
char *strcpy(char *to, const char *from);
char *strncpy(char *to, const char *from, size_t size);
char *strchr(const char *in, int c);
char *strrchr(const char *in, int c);
char *strpbrk(const char *in, const char *any);
char *strstr(const char *in, const char *text);
size_t strspn(const char *text, const char *accepted);
size_t strcspn(const char *text, const char *rejected);
char *strerror(int error);

#endif
