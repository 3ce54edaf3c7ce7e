// How well the robot keeps to the tape on the floor, by geometry.
#pragma once

#include <cstdint>
#include <vector>

#include "scene.h"

namespace frob::sim
{

// Where tape is nearest to a point.
struct OnTape {
    std::size_t tape; // in the scene's order
    double distance;  // from its middle line
    double along;     // from its first point on
};

// The scene has tape.
OnTape nearest_on_tape(const Scene &scene, Vec point);

// What a run came to.
class TapeDistance
{
  public:
    // The scene must outlive it, and has tape.
    TapeDistance(const Scene &scene, const MeasureSettings &settings);

    // Takes the robot's pose at a controller's instant. Returns the distance of
    // the middle of its axle from the nearest tape's middle line.
    double observe(std::int64_t time_ns, const Pose &robot);

    // Since the robot settled; NaN if it has not.
    double mean() const;
    double largest() const;

    // How far it has come along the tape since it settled, in the order of the tape's points;
    // round a closed one again and again. What is too far from one instant to
    // the next (at a crossing, or from one tape to another) does not count.
    double way() const { return way_; }

  private:
    const Scene &scene_;
    MeasureSettings settings_;
    std::vector<double> lengths_; // of the closed tapes; 0 of others
    bool settled_ = false;
    OnTape before_{};
    double sum_ = 0.0, largest_ = 0.0, way_ = 0.0;
    std::int64_t count_ = 0;
};

} // namespace frob::sim
