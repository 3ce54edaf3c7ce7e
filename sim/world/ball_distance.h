// How well the robot keeps its distance from a ball, by geometry.
#pragma once

#include <cstdint>
#include <vector>

#include "scene.h"

namespace frob::sim
{

class BallDistance
{
  public:
    explicit BallDistance(const MeasureSettings &settings) : settings_(settings) {}

    // Takes the robot's pose and where the balls are, at a controller's instant. Returns the
    // distance of the middle of its axle from the middle of the nearest ball, over the floor.
    double observe(std::int64_t time_ns, const Pose &robot, const std::vector<Vec> &balls);

    // Since the robot settled; NaN if it has not.
    double mean_error() const;
    double largest_error() const;

  private:
    MeasureSettings settings_;
    double sum_ = 0.0, largest_ = 0.0;
    std::int64_t count_ = 0;
};

} // namespace frob::sim
