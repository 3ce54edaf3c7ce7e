/* Types for the functions in foreign.frob. The header generated from that file needs them. */
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
