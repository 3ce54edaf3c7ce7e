#include "odometry.h"

#include <cmath>

#include "p3dx.h"
#include "world.h"

namespace frob::sim {

// With d the distance travelled and a the angle turned in a step,
//   d = h (v_right + v_left) / 2,   a = h (v_right - v_left) / b,
// each off by its relative error, and a by a part that grows with d:
//   a += veer d + noise sqrt(|d|).
// The position moves along the heading at the middle of the step.
void Odometry::advance(double left_speed, double right_speed) {
    const double travelled = step_s * (right_speed + left_speed) / 2;
    const double turned = step_s * (right_speed - left_speed) / p3dx::wheel_separation;
    const double d = (1 + settings_.distance_error) * travelled;
    double a = (1 + settings_.turn_error) * turned + settings_.veer * travelled;
    if (settings_.heading_noise > 0.0)
        a += settings_.heading_noise * noise_.normal() * std::sqrt(std::abs(travelled));
    pose_.position = pose_.position + d * turned_a_little(ahead_, a / 2);
    pose_.heading = wrap_angle(pose_.heading + a);
    ahead_ = turned_a_little(ahead_, a);
}

} // namespace frob::sim
