/* calls.h -- the kernels by their names, each called in one way: with the addresses of its
 * arguments, which are images or structs as generated C has them (a number is a struct of
 * one), and of its result. */
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
