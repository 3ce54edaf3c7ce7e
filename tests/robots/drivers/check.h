/* Checks for the runtime's tests. Each prints a line, `ok NAME` or `FAIL NAME`. */
#ifndef CHECK_H
#define CHECK_H

#include <math.h>
#include <stdbool.h>
#include <stdio.h>

static int check_failures = 0;

static inline void check(bool holds, const char *name)
{
    printf("%s %s\n", holds ? "ok" : "FAIL", name);
    if (!holds)
        check_failures++;
}

/* Checks that a value is within `tolerance` of the expected one; prints both if it is not. */
static inline void check_near(double found, double expected, double tolerance, const char *name)
{
    bool holds = fabs(found - expected) <= tolerance;
    check(holds, name);
    if (!holds)
        printf("     found %.9g, expected %.9g\n", found, expected);
}

static inline int check_status(void)
{
    return check_failures == 0 ? 0 : 1;
}

#endif
