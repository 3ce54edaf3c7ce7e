/* calls.h -- a table of the kernels by name. They share one calling convention: a call takes the
 * addresses of the arguments and of the result. Each argument is an image, or a struct as in
 * generated C (a number is a struct with one member). */
#ifndef FROB_KERNEL_CALLS_H
#define FROB_KERNEL_CALLS_H

#include <stddef.h>

struct kernel {
    const char *name;
    void (*call)(const void *const *arguments, void *result);
};

extern const struct kernel frob_kernels[];
extern const size_t frob_kernel_count;

#endif
