#include "super_scout.h"

#include "drivers/scout/command.h"

namespace frob::sim::super_scout {
namespace {

constexpr double radius = 0.2;              // m, an estimate
constexpr double mass = 25.0;               // kg, an estimate
constexpr double inch = 0.0254;             // m
constexpr double wheel_separation = 0.3452; // m

std::vector<Pose> seats() {
    std::vector<Pose> seats;
    for (std::size_t i = 0; i < sonar_count; ++i) {
        const double angle = wrap_angle(radians(22.5) * static_cast<double>(i));
        seats.push_back({radius * direction(angle), angle});
    }
    return seats;
}

} // namespace

// The inertia is that of a uniform disc: I = m r^2 / 2. The largest turn rate is that of wheels
// running at 1 m/s in opposite directions. Accelerations and forces are estimates.
const Chassis &chassis() {
    static const Chassis chassis = {
        "Super Scout",
        mass,
        mass * radius * radius / 2.0,
        {0.0, 0.0},
        radius,
        {},
        0.08,
        wheel_separation,
        50.0,
        0.0,
        12.0,
        {FROB_SCOUT_MAX_M_S, radians(300.0), 0.76, radians(200.0)},
        frob_scout_wire(wheel_separation),
        {0.0, radius},
        {0.0, -radius},
        {seats(), radians(10.0), 4, 12, {0, 1, 15}, "sonar"},
    };
    return chassis;
}

// The transducers fire one at a time, alternately on the left and right, from the front to the
// rear.
const SonarRing &ring() {
    static const SonarRing ring = {
        40'000'000, {{{0, 2, 15, 1, 14, 3, 13, 4, 12, 5, 11, 6, 10, 7, 9, 8}, 0}},
        6 * inch, // an estimate
        255 * inch, inch,
    };
    return ring;
}

} // namespace frob::sim::super_scout
