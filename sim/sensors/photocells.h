// Photocells, which see the light of lamps and of the room.
#pragma once

#include <cstdint>
#include <vector>

#include "body.h"
#include "noise.h"
#include "scene.h"

namespace frob::sim
{

class Photocells
{
  public:
    // Each has a seat in the robot's frame, in whose direction it looks, and
    // something new every `refresh_ns`, a multiple of the physics' step.
    Photocells(std::vector<Pose> seats, std::int64_t refresh_ns, const Scene &scene, Noise noise)
        : seats_(std::move(seats)), refresh_ns_(refresh_ns), lamps_(scene.lamps),
          ambient_(scene.ambient), noise_(noise), seen_(seats_.size())
    {
    }

    // Looks; called after each physics step, with the time since the start.
    void advance(std::int64_t time_ns, const Body &body);

    // What each sees: lx, with noise; 0 or more.
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
