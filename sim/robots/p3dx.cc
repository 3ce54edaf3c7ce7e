#include "p3dx.h"

#include "drivers/pioneer/speeds.h"

namespace frob::sim::p3dx {

// The centre of mass is near the axle, because of the batteries and motors. The inertia is that of
// a plate of the body's size: I = m (l^2 + w^2) / 12.
const Chassis &chassis() {
    static const Chassis chassis = {
        "Pioneer P3-DX",
        mass,
        mass / 12.0 * (body_length * body_length + body_width * body_width),
        {body_center, 0.0},
        0.0,
        {outline.begin(), outline.end()},
        wheel_radius,
        wheel_separation,
        wheel_force,
        0.0,
        12.8,
        {FROB_PIONEER_MOST_M_S, FROB_PIONEER_MOST_RAD_S, 0.3, radians(100.0)},
        frob_pioneer_wire(FROB_PIONEER_MOST_M_S, FROB_PIONEER_MOST_RAD_S),
        sonars[left_sonar].position,
        sonars[right_sonar].position,
        {{sonars.begin(), sonars.end()},
         sonar_half_angle,
         left_sonar,
         right_sonar,
         {front_sonars.begin(), front_sonars.end()},
         "sonar"},
    };
    return chassis;
}

// Two arrays, whose transducers fire in turn. Neighbours never fire one directly after the other,
// so that no transducer hears its neighbour's ping.
const SonarRing &ring() {
    static const SonarRing ring = {
        40'000'000,
        {{{0, 4, 1, 5, 2, 6, 3, 7}, 0}, {{8, 12, 9, 13, 10, 14, 11, 15}, 20'000'000}},
        sonar_nearest,
        sonar_farthest,
        0.0,
    };
    return ring;
}

} // namespace frob::sim::p3dx
