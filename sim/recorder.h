// What happened at each of the controller's instants, kept for the picture.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry.h"

namespace frob::sim {

struct Sample {
    std::int64_t time_ns;
    Pose pose;               // the truth
    Pose believed;           // by odometry, placed at the true start
    double forward, turn;    // m/s and rad/s, of the body
    double commanded_forward, commanded_turn;
    double wall_distance; // m; NaN where the world file measures nothing
    int collisions;       // so far
};

class Recorder {
  public:
    void add(const Sample &sample);
    const std::vector<Sample> &samples() const { return samples_; }

    // Metres along the true path.
    double distance_driven() const { return distance_driven_; }

  private:
    std::vector<Sample> samples_;
    double distance_driven_ = 0.0;
};

} // namespace frob::sim
