/* <errno.h>, for frob-tcc: the part of the standard header that Frob needs. */
#ifndef FROB_TCC_ERRNO_H
#define FROB_TCC_ERRNO_H

int *__errno_location(void);
#define errno (*__errno_location())

#define EDOM 33
#define ERANGE 34
#define EINVAL 22

#endif
