/* arithmetic.c -- asks, before anything else is tried, whether numbers are what
 * programs are compiled for. Prints `right`, or the reason why not. */
#include <frob/arithmetic.h>

#include <stdio.h>

int main(void)
{
    const unsigned faults = frob_arithmetic_faults() | frob_arithmetic_float_faults();
    puts(faults == 0 ? "right" : frob_arithmetic_reason(faults));
    return faults != 0;
}
