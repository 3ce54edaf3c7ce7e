#include "drive.h"

#include <algorithm>
#include <cmath>

#include "body.h"

namespace frob::sim {
namespace {

constexpr double tyre_grip = 60.0;   // N, the largest sideways force before the wheels skid
constexpr double slip_lasts_s = 0.1; // time after which each wheel gets a new random slip
constexpr double stall_after_s = 0.2;
constexpr double standing = 0.02; // m/s; a slower wheel counts as stationary

double approach(double from, double to, double most) {
    return from + std::clamp(to - from, -most, most);
}

} // namespace

DifferentialDrive::DifferentialDrive(const Chassis &chassis, const DriveSettings &settings,
                                     Noise noise)
    : chassis_(chassis),
      limits_{settings.max_speed.value_or(chassis.limits.speed),
              settings.max_turn.value_or(chassis.limits.turn),
              settings.acceleration.value_or(chassis.limits.acceleration),
              settings.turn_acceleration.value_or(chassis.limits.turn_acceleration)},
      slip_(settings.slip), noise_(noise), behind_wire_(settings.behind_wire) {}

// First applies the limits and the rounding of the robot's driver, which depend on the protocol,
// then the limits of the robot's firmware.
void DifferentialDrive::command(std::int64_t time_ns, double forward, double turn) {
    if (!std::isfinite(forward) || !std::isfinite(turn)) forward = turn = 0.0;
    const frob_wire &wire = chassis_.wire;
    if (!behind_wire_ && wire.step[0] > 0.0 && wire.step[1] > 0.0) {
        const double most_turn =
            wire.wheels ? frob_wheels_most(1, wire.separation_m, wire.most[1]) : wire.most[1];
        numbers_ = frob_wire_next(
            &wire, &numbers_, std::clamp(forward, -wire.most[0], wire.most[0]),
            std::clamp(turn, -most_turn, most_turn), static_cast<double>(time_ns) * 1e-9);
        forward = frob_wire_forward(&wire, &numbers_);
        turn = frob_wire_turn(&wire, &numbers_);
    }
    forward_ = std::clamp(forward, -limits_.speed, limits_.speed);
    turn_ = std::clamp(turn, -limits_.turn, limits_.turn);
}

// Limits the accelerations of v and omega as the firmware does, and computes the wheels' speeds:
//   v_left = v - omega b / 2,   v_right = v + omega b / 2.
void DifferentialDrive::ramp() {
    const double b = chassis_.wheel_separation;
    const double v =
        approach((left_.setpoint + right_.setpoint) / 2, forward_, limits_.acceleration * step_s);
    const double omega =
        approach((right_.setpoint - left_.setpoint) / b, turn_, limits_.turn_acceleration * step_s);
    left_.setpoint = v - omega * b / 2;
    right_.setpoint = v + omega * b / 2;
}

// Each wheel loses a random fraction of its travel, uniformly distributed between 0 and twice the
// mean.
void DifferentialDrive::draw_slip() {
    slip_age_s_ += step_s;
    if (slip_drawn_ && slip_age_s_ < slip_lasts_s) return;
    slip_drawn_ = true;
    slip_age_s_ = 0.0;
    left_.lost = 2 * slip_ * noise_.uniform();
    right_.lost = 2 * slip_ * noise_.uniform();
}

// Limits a wheel's force on the floor to `wheel_force`. If that is not enough, the motor stalls:
// the wheel turns only as fast as it moves over the floor, and the setpoint stays near that speed.
double DifferentialDrive::push(Wheel &wheel, double contact_speed, double wanted_force) const {
    const double force = std::clamp(wanted_force, -chassis_.wheel_force, chassis_.wheel_force);
    const bool held = force != wanted_force;
    wheel.measured = held ? contact_speed / (1 - wheel.lost) : wheel.setpoint;
    if (held)
        wheel.setpoint = (contact_speed + force * step_s / (chassis_.mass / 2)) / (1 - wheel.lost);
    wheel.strained_s = held && std::abs(contact_speed) < standing ? wheel.strained_s + step_s : 0.0;
    return force;
}

// Let v* and omega* be the body's target speeds, which follow from the wheels' setpoints and slip,
// m and I its mass and moment of inertia, and h the time step. The forces that bring the body to
// these speeds within the step are
//   F_right + F_left = m (v* - v) / h,
//   F_right - F_left = 2 I (omega* - omega) / (b h),
// and -m v_across / h sideways, where the wheels do not roll. Directions are those at the middle of
// the step, so that a turn is an arc.
void DifferentialDrive::advance(b2Body &body) {
    const double b = chassis_.wheel_separation;
    ramp();
    draw_slip();
    const double left_floor = left_.setpoint * (1 - left_.lost);
    const double right_floor = right_.setpoint * (1 - right_.lost);
    const double v_wanted = (left_floor + right_floor) / 2;
    const double omega_wanted = (right_floor - left_floor) / b;

    const double omega = static_cast<double>(body.GetAngularVelocity());
    const b2Rot ahead = body.GetTransform().q;
    const Vec along = turned_a_little({static_cast<double>(ahead.c), static_cast<double>(ahead.s)},
                                      omega_wanted * step_s / 2);
    const Vec across = {-along.y, along.x};
    const Vec velocity = {static_cast<double>(body.GetLinearVelocity().x),
                          static_cast<double>(body.GetLinearVelocity().y)};
    const double v = dot(velocity, along);

    const double m = static_cast<double>(body.GetMass());
    const double inertia = static_cast<double>(body.GetInertia());
    const double sum = m * (v_wanted - v) / step_s;
    const double difference = 2 * inertia * (omega_wanted - omega) / (b * step_s);
    const double right = push(right_, v + omega * b / 2, (sum + difference) / 2);
    const double left = push(left_, v - omega * b / 2, (sum - difference) / 2);
    const double sideways = std::clamp(-m * dot(velocity, across) / step_s, -tyre_grip, tyre_grip);

    const Vec impulse = step_s * ((right + left) * along + sideways * across);
    body.ApplyLinearImpulseToCenter({static_cast<float>(impulse.x), static_cast<float>(impulse.y)},
                                    true);
    body.ApplyAngularImpulse(static_cast<float>((right - left) * b / 2 * step_s), true);
}

bool DifferentialDrive::left_stalled() const { return left_.strained_s >= stall_after_s; }
bool DifferentialDrive::right_stalled() const { return right_.strained_s >= stall_after_s; }

} // namespace frob::sim
