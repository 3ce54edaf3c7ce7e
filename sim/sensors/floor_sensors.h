// Sensors that look down at the floor. Each sensor has its own light, and measures how much of that
// light the floor reflects.
#pragma once

#include <cstdint>
#include <vector>

#include "body.h"
#include "floor.h"
#include "noise.h"

namespace frob::sim {

class FloorSensors {
  public:
    // Each sensor looks at a spot of width `spot` below its place in the robot's frame, and updates
    // every `refresh_ns`, a multiple of the physics step.
    FloorSensors(std::vector<Vec> places, double spot, std::int64_t refresh_ns,
                 const FloorSettings &settings, Noise noise)
        : places_(std::move(places)), spot_(spot), refresh_ns_(refresh_ns), settings_(settings),
          noise_(noise), seen_(places_.size()) {}

    // Updates the readings. Must be called after each physics step, with the time since the start.
    void advance(std::int64_t time_ns, const Body &body, const Floor &floor);

    // The reading of each sensor: the reflectance of its spot, with noise; never negative.
    const std::vector<double> &seen() const { return seen_; }

  private:
    std::vector<Vec> places_;
    double spot_;
    std::int64_t refresh_ns_;
    FloorSettings settings_;
    Noise noise_;
    std::vector<double> seen_;
};

} // namespace frob::sim
