/* arithmetic.c -- the first program of the self-test. It checks that numbers have the properties
 * that generated C relies on, and prints `right` or the violated property. */
#include <frob/arithmetic.h>

#include <stdio.h>

int main(void)
{
    const unsigned faults = frob_arithmetic_faults() | frob_arithmetic_float_faults();
    puts(faults == 0 ? "right" : frob_arithmetic_reason(faults));
    return faults != 0;
}
