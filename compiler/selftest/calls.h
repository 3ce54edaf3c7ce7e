/* Types of foreign.frob's functions, which its generated header needs. */
#ifndef CALLS_H
#define CALLS_H

#include <stdint.h>

struct span {
    double from, to;
};

struct sway_state {
    double last;
    int32_t count;
};

#endif
