// Records the robot's data whenever the controller runs, for the picture.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry.h"

namespace frob::sim {

struct Sample {
    std::int64_t time_ns;
    Pose pose;            // the true pose
    Pose believed;        // pose according to odometry, which starts at the true pose
    double forward, turn; // m/s and rad/s, of the body
    double commanded_forward, commanded_turn;
    double measured_distance; // m, distance from the wall, tape or ball; NaN if nothing is measured
    int collisions;           // number of collisions so far
};

class Recorder {
  public:
    explicit Recorder(bool keeps_samples) : keeps_samples_(keeps_samples) {}

    // Records that the robot has reached this place, for `distance_driven`. Called even if no
    // samples are stored.
    void arrive(Vec position);
    void add(const Sample &sample) { samples_.push_back(sample); }
    bool keeps_samples() const { return keeps_samples_; }
    const std::vector<Sample> &samples() const { return samples_; }

    // The distance along the true path, in metres.
    double distance_driven() const { return distance_driven_; }

  private:
    bool keeps_samples_;
    std::vector<Sample> samples_;
    std::optional<Vec> last_;
    double distance_driven_ = 0.0;
};

} // namespace frob::sim
