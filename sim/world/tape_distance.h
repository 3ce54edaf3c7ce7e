// Measures how well the robot keeps to the tape on the floor, based on its true position.
#pragma once

#include <cstdint>
#include <vector>

#include "scene.h"

namespace frob::sim {

// The place on a tape that is nearest to a given point.
struct OnTape {
    std::size_t tape; // index of the tape in the scene
    double distance;  // distance from the centre line of the tape
    double along;     // distance along the tape from its first point
};

// The scene must contain a tape.
OnTape nearest_on_tape(const Scene &scene, Vec point);

// Accumulates the measurements of a run.
class TapeDistance {
  public:
    // The scene must contain a tape, and must outlive this object.
    TapeDistance(const Scene &scene, const MeasureSettings &settings);

    // Records the robot's pose at a step of the controller. Returns the distance from the middle of
    // its axle to the centre line of the nearest tape.
    double observe(std::int64_t time_ns, const Pose &robot);

    // Distances since the robot settled; NaN if it has not settled.
    double mean() const;
    double largest() const;

    // Distance travelled along the tape since the robot settled, positive in the order of the
    // tape's points; on a closed tape, laps add up. Jumps between two instants (at a crossing, or
    // from one tape to another) do not count.
    double way() const { return way_; }

  private:
    const Scene &scene_;
    MeasureSettings settings_;
    std::vector<double> lengths_; // length of each closed tape; 0 for other tapes
    bool settled_ = false;
    OnTape before_{};
    double sum_ = 0.0, largest_ = 0.0, way_ = 0.0;
    std::int64_t count_ = 0;
};

} // namespace frob::sim
