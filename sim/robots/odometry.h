// Dead reckoning from the wheels' speeds, with the errors of a real robot.
#pragma once

#include "chassis.h"
#include "noise.h"
#include "scene.h"

namespace frob::sim {

class Odometry {
  public:
    // The chassis must outlive the odometry.
    Odometry(const Chassis &chassis, const OdometrySettings &settings, Noise noise)
        : chassis_(chassis), settings_(settings), noise_(noise) {}

    // Adds the movement in one physics step at these wheel speeds, in m/s.
    void advance(double left_speed, double right_speed);

    // The robot's estimated pose relative to its start; heading in (-pi, pi].
    const Pose &pose() const { return pose_; }

  private:
    double counted(double &way, double speed) const;

    const Chassis &chassis_;
    OdometrySettings settings_;
    Noise noise_;
    Pose pose_;
    Vec ahead_{1.0, 0.0};                     // unit vector in the direction of the heading
    double left_way_ = 0.0, right_way_ = 0.0; // the distance that each wheel has
                                              // travelled since its last count
};

} // namespace frob::sim
