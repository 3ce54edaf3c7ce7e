// Checks for the simulator's tests. Each prints a line, `ok NAME` or `FAIL NAME`.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>

namespace check
{

inline int failures = 0;

inline void that(bool holds, const std::string &name)
{
    std::printf("%s %s\n", holds ? "ok" : "FAIL", name.c_str());
    if (!holds)
        ++failures;
}

// Checks that a value is within `tolerance` of the expected one; prints both if it is not.
inline void near(double found, double expected, double tolerance, const std::string &name)
{
    const bool holds = std::abs(found - expected) <= tolerance;
    that(holds, name);
    if (!holds)
        std::printf("     found %.9g, expected %.9g to %.2g\n", found, expected, tolerance);
}

inline int status()
{
    return failures == 0 ? 0 : 1;
}

} // namespace check
