// The contacts of a robot with other objects, and the number of collisions.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "body.h"

namespace frob::sim {

class Contacts {
  public:
    // Reads the contacts; called after each physics step.
    void advance(const Body &body);

    // Contact points, in the robot's frame.
    const std::vector<Vec> &points() const { return points_; }

    // The number of collisions with fixed objects, boxes, balls and other robots. A collision
    // between two robots counts for both. A collision ends when the robot has not touched
    // anything for half a second.
    int collisions() const { return collisions_; }

    // A collision that began at the last step: the object, and the place in the world.
    struct Begun {
        const b2Fixture *with;
        Vec where;
    };
    const std::optional<Begun> &begun() const { return begun_; }

  private:
    static constexpr std::int64_t apart_ns = 500'000'000;

    std::vector<Vec> points_;
    std::optional<Begun> begun_;
    int collisions_ = 0;
    std::int64_t free_ns_ = apart_ns;
};

} // namespace frob::sim
