/* What foreign.frob calls, as its generated header needs to know it. */
#ifndef CALLS_H
#define CALLS_H

struct span {
    double from, to;
};

struct mean_state {
    double sum;
    int count;
};

#endif
