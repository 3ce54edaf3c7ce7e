#include <frob/elementary.h>

#include "exp_kernel.h"

double frob_exp(double x)
{
    if (isnan(x))
        return NAN;
    struct pair const exact = { x, 0.0 };
    return exp_of_pair(exact);
}
