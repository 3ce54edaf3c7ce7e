// The differential drive: two wheels, their motors, and the firmware's limits.
#pragma once

#include <cstdint>

#include <box2d/box2d.h>

#include "chassis.h"
#include "noise.h"
#include "scene.h"

namespace frob::sim {

class DifferentialDrive {
  public:
    // The chassis must outlive the drive.
    DifferentialDrive(const Chassis &chassis, const DriveSettings &settings, Noise noise);

    // Sets the speed for the following steps: forward in m/s, turn counter-clockwise in rad/s. The
    // drive limits both. It also rounds them as the robot's driver does, unless simulated firmware
    // has already done so. If either of them is not finite, the robot stops.
    void command(std::int64_t time_ns, double forward, double turn);

    // Applies the wheels' forces to the body for the next physics step.
    void advance(b2Body &body);

    // Speeds of the wheels' rims in m/s, as the encoders see them.
    double left_speed() const { return left_.measured; }
    double right_speed() const { return right_.measured; }

    // Whether the motor has pushed with full force for a while without moving the wheel.
    bool left_stalled() const;
    bool right_stalled() const;

    double commanded_forward() const { return forward_; }
    double commanded_turn() const { return turn_; }

  private:
    struct Wheel {
        double setpoint = 0.0;   // m/s, the firmware's current target
        double measured = 0.0;   // m/s
        double lost = 0.0;       // the fraction of the wheel's travel that is lost to slip
        double strained_s = 0.0; // s, the time at full force without movement
    };

    void ramp();
    void draw_slip();
    double push(Wheel &wheel, double contact_speed, double wanted_force) const;

    const Chassis &chassis_;
    DriveLimits limits_;
    double slip_;
    Noise noise_;
    bool behind_wire_; // whether commands come from simulated firmware, which has already rounded
                       // them to whole steps
    frob_wire_numbers numbers_{};
    double forward_ = 0.0, turn_ = 0.0;
    Wheel left_, right_;
    double slip_age_s_ = 0.0;
    bool slip_drawn_ = false;
};

} // namespace frob::sim
