#include "odometry.h"

#include <cmath>

#include "body.h"

namespace frob::sim {

// Rounds a wheel's travel in a step to whole encoder counts, and returns the resulting speed.
double Odometry::counted(double &way, double speed) const {
    if (chassis_.count == 0.0) return speed;
    way += step_s * speed;
    const double whole = chassis_.count * std::trunc(way / chassis_.count);
    way -= whole;
    return whole / step_s;
}

// Let d be the distance travelled and a the angle turned in a step:
//   d = h (v_right + v_left) / 2,   a = h (v_right - v_left) / b.
// Both have a relative error. The angle a has a further error, which grows with d:
//   a += veer d + noise sqrt(|d|).
// The position moves along the heading at the middle of the step.
void Odometry::advance(double left_speed, double right_speed) {
    const double left = counted(left_way_, left_speed), right = counted(right_way_, right_speed);
    const double travelled = step_s * (right + left) / 2;
    const double turned = step_s * (right - left) / chassis_.wheel_separation;
    const double d = (1 + settings_.distance_error) * travelled;
    double a = (1 + settings_.turn_error) * turned + settings_.veer * travelled;
    if (settings_.heading_noise > 0.0)
        a += settings_.heading_noise * noise_.normal() * std::sqrt(std::abs(travelled));
    pose_.position = pose_.position + d * turned_a_little(ahead_, a / 2);
    pose_.heading = wrap_angle(pose_.heading + a);
    ahead_ = turned_a_little(ahead_, a);
}

} // namespace frob::sim
