#include "pioneer_motion.h"

#include <algorithm>
#include <cmath>

#include "geometry.h"

namespace frob::serve {
namespace {

// Limits for MOVE and HEAD. These commands brake gently enough for the body, whose own limits are
// slightly higher. The speed limits apply unless the client sets others.
constexpr double braking = 0.2, turn_braking = 1.0; // m/s^2, rad/s^2
constexpr double move_speed = 0.3, head_turn = 1.0;
constexpr double there = 0.002, faces = 0.004; // m, rad

// The highest speed at which the robot can still stop before the goal: v^2 = 2 a d. Near the
// goal the speed is even lower, because speeds are updated in steps.
double towards(double way, double most, double brake) {
    const double speed =
        std::min({most, std::sqrt(2 * brake * std::fabs(way)), 4 * std::fabs(way)});
    return std::copysign(speed, way);
}

double angle_between(double from, double to) { return std::remainder(to - from, 2 * sim::pi); }

} // namespace

void PioneerMotion::Axis::want(double value) { wanted = std::clamp(value, -most, most); }

// Moving away from zero counts as speeding up, and moving towards it as braking.
void PioneerMotion::Axis::approach(double elapsed_s) {
    const bool brakes = wanted * told < 0 || std::fabs(wanted) < std::fabs(told);
    const double acceleration = brakes ? down : up;
    if (acceleration <= 0) {
        told = wanted;
        return;
    }
    const double step = acceleration * elapsed_s;
    told += std::clamp(wanted - told, -step, step);
}

PioneerMotion::PioneerMotion(double top_speed, double top_turn)
    : forward_{top_speed, top_speed}, turn_{top_turn, top_turn} {}

void PioneerMotion::set_speed(double speed) {
    left_.reset();
    forward_.want(speed);
    forward_.approach(0);
}

void PioneerMotion::set_turn(double turn) {
    heading_.reset();
    turn_.want(turn);
    turn_.approach(0);
}

void PioneerMotion::move(double distance) { left_ = distance; }

void PioneerMotion::face(double heading) { heading_ = angle_between(0, heading); }

void PioneerMotion::face_by(double angle, double from) { face(from + angle); }

void PioneerMotion::stop() {
    set_speed(0);
    set_turn(0);
}

void PioneerMotion::halt() {
    stop();
    forward_.told = turn_.told = 0;
}

void PioneerMotion::limit_speed(double most) {
    forward_.most = std::clamp(most, 0.0, forward_.top);
}
void PioneerMotion::limit_turn(double most) { turn_.most = std::clamp(most, 0.0, turn_.top); }

void PioneerMotion::accelerate(double a) { (a < 0 ? forward_.down : forward_.up) = std::fabs(a); }
void PioneerMotion::accelerate_turn(double a) { (a < 0 ? turn_.down : turn_.up) = std::fabs(a); }

void PioneerMotion::advance(const PioneerState &state, double elapsed_s) {
    if (left_) {
        *left_ -= state.speed * elapsed_s;
        const double most = forward_.most < forward_.top ? forward_.most : move_speed;
        const bool arrived = std::fabs(*left_) < there;
        forward_.wanted = arrived ? 0.0 : towards(*left_, most, braking);
        if (arrived && state.speed == 0.0) left_.reset();
    }
    if (heading_) {
        const double way = angle_between(state.heading, *heading_);
        const double most = turn_.most < turn_.top ? turn_.most : head_turn;
        turn_.wanted = std::fabs(way) < faces ? 0.0 : towards(way, most, turn_braking);
    }
    forward_.approach(elapsed_s);
    turn_.approach(elapsed_s);
}

} // namespace frob::serve
