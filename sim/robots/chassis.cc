#include "chassis.h"

namespace frob::sim {

std::vector<Vec> outline_of(const Chassis &chassis) {
    if (!chassis.outline.empty()) return chassis.outline;
    constexpr int corners = 48;
    std::vector<Vec> outline;
    for (int i = 0; i < corners; ++i)
        outline.push_back(chassis.center + chassis.radius * direction(2 * pi * i / corners));
    return outline;
}

} // namespace frob::sim
