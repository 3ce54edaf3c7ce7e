// Measures how well the robot keeps its distance from a ball, based on the true positions.
#pragma once

#include <cstdint>
#include <vector>

#include "scene.h"

namespace frob::sim {

class BallDistance {
  public:
    explicit BallDistance(const MeasureSettings &settings) : settings_(settings) {}

    // Records the robot's pose and the positions of the balls at a step of the controller.
    // Returns the horizontal distance from the middle of the robot's axle to the centre of the
    // nearest ball.
    double observe(std::int64_t time_ns, const Pose &robot, const std::vector<Vec> &balls);

    // Errors since the robot settled; NaN if it has not settled.
    double mean_error() const;
    double largest_error() const;

  private:
    MeasureSettings settings_;
    double sum_ = 0.0, largest_ = 0.0;
    std::int64_t count_ = 0;
};

} // namespace frob::sim
