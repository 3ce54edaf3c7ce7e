#include "p3dx.h"

namespace frob::sim::p3dx
{

// Batteries and motors put the middle of mass near the axle. As for a plate of
// the body's size: I = m (l^2 + w^2) / 12.
const Chassis &chassis()
{
    static const Chassis chassis = {
        "Pioneer P3-DX",
        mass,
        mass / 12.0 * (body_length * body_length + body_width * body_width),
        { body_center, 0.0 },
        0.0,
        { outline.begin(), outline.end() },
        wheel_radius,
        wheel_separation,
        wheel_force,
        0.0,
        12.8,
        { 1.2, radians(300.0), 0.3, radians(100.0) },
        sonars[left_sonar].position,
        sonars[right_sonar].position,
        { { sonars.begin(), sonars.end() },
          sonar_half_angle,
          left_sonar,
          right_sonar,
          { front_sonars.begin(), front_sonars.end() },
          "sonar" },
    };
    return chassis;
}

// Two arrays that take turns. The order is one in which neighbours never follow
// each other, so that none hears the other's ping.
const SonarRing &ring()
{
    static const SonarRing ring = {
        40'000'000,
        { { { 0, 4, 1, 5, 2, 6, 3, 7 }, 0 }, { { 8, 12, 9, 13, 10, 14, 11, 15 }, 20'000'000 } },
        sonar_nearest,
        sonar_farthest,
        0.0,
    };
    return ring;
}

} // namespace frob::sim::p3dx
