// Dead reckoning from the wheels' speeds, with the errors of a real robot.
#pragma once

#include "chassis.h"
#include "noise.h"
#include "scene.h"

namespace frob::sim
{

class Odometry
{
  public:
    // The robot's description must outlive the odometry.
    Odometry(const Chassis &chassis, const OdometrySettings &settings, Noise noise)
        : chassis_(chassis), settings_(settings), noise_(noise)
    {
    }

    // Counts one physics step at these wheel speeds, in m/s.
    void advance(double left_speed, double right_speed);

    // Where the robot believes it is, relative to where it started; heading in
    // (-pi, pi].
    const Pose &pose() const { return pose_; }

  private:
    double counted(double &way, double speed) const;

    const Chassis &chassis_;
    OdometrySettings settings_;
    Noise noise_;
    Pose pose_;
    Vec ahead_{ 1.0, 0.0 };                   // the direction of its heading
    double left_way_ = 0.0, right_way_ = 0.0; // since the last count of each wheel
};

} // namespace frob::sim
