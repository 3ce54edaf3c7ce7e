#include <frob/elementary.h>
#include <math.h>

#include "log_kernel.h"

double frob_log(double x)
{
    if (isnan(x) || x < 0.0)
        return NAN;
    if (x == 0.0)
        return -INFINITY;
    if (isinf(x))
        return INFINITY;
    return log_pair(x).high;
}
