// The differential drive: two wheels, their motors, and the firmware's limits.
#pragma once

#include <box2d/box2d.h>

#include "chassis.h"
#include "noise.h"
#include "scene.h"

namespace frob::sim
{

class DifferentialDrive
{
  public:
    // The robot's description must outlive the drive.
    DifferentialDrive(const Chassis &chassis, const DriveSettings &settings, Noise noise);

    // What the robot should do from now on: forward in m/s, turn
    // counter-clockwise in rad/s. Values out of range are limited; if either is
    // NaN the robot comes to rest.
    void command(double forward, double turn);

    // Pushes the body for the next physics step.
    void advance(b2Body &body);

    // Speeds of the wheels' rims in m/s, as the encoders see them.
    double left_speed() const { return left_.measured; }
    double right_speed() const { return right_.measured; }

    // The motor has pushed with all its force for a while, and the wheel stands.
    bool left_stalled() const;
    bool right_stalled() const;

    double commanded_forward() const { return forward_; }
    double commanded_turn() const { return turn_; }

  private:
    struct Wheel {
        double setpoint = 0.0;   // m/s that the firmware asks for at the moment
        double measured = 0.0;   // m/s
        double lost = 0.0;       // share of its travel
        double strained_s = 0.0; // time at full force without moving
    };

    void ramp();
    void draw_slip();
    double push(Wheel &wheel, double contact_speed, double wanted_force) const;

    const Chassis &chassis_;
    DriveLimits limits_;
    double slip_;
    Noise noise_;
    double forward_ = 0.0, turn_ = 0.0;
    Wheel left_, right_;
    double slip_age_s_ = 0.0;
    bool slip_drawn_ = false;
};

} // namespace frob::sim
