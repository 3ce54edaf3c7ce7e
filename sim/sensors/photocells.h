// Photocells, which measure the light from lamps and the ambient light of the room.
#pragma once

#include <cstdint>
#include <vector>

#include "body.h"
#include "noise.h"
#include "scene.h"

namespace frob::sim {

class Photocells {
  public:
    // Each photocell has a fixed position and direction in the robot's frame, and updates every
    // `refresh_ns`, a multiple of the physics step.
    Photocells(std::vector<Pose> seats, std::int64_t refresh_ns, const Scene &scene, Noise noise)
        : seats_(std::move(seats)), refresh_ns_(refresh_ns), lamps_(scene.lamps),
          ambient_(scene.ambient), noise_(noise), seen_(seats_.size()) {}

    // Updates the readings; called after each physics step, with the time since the start.
    void advance(std::int64_t time_ns, const Body &body);

    // The reading of each photocell in lx, with noise; never negative.
    const std::vector<double> &seen() const { return seen_; }

  private:
    double from_lamp(const Lamp &lamp, const Pose &cell, const Body &body) const;

    std::vector<Pose> seats_;
    std::int64_t refresh_ns_;
    std::vector<Lamp> lamps_;
    AmbientSettings ambient_;
    Noise noise_;
    std::vector<double> seen_;
};

} // namespace frob::sim
