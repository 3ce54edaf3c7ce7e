// A robot's body in the world: its pose, and the objects around it.
#pragma once

#include <cstdint>
#include <optional>

#include <box2d/box2d.h>

#include "geometry.h"

namespace frob::sim {

// The fixed time step of the physics. A robot at full speed moves only 6 mm per step, and the time
// between two pings of a sonar is a multiple of the step.
constexpr std::int64_t step_ns = 5'000'000;
constexpr double step_s = 0.005;

class Body {
  public:
    // The physics engine owns the body, which must outlive this object.
    explicit Body(b2Body &rigid) : rigid_(&rigid) {}

    // The true pose; heading in (-pi, pi].
    Pose pose() const;

    // Casts a ray of length `reach` from `origin` in direction `angle`. Returns the distance to the
    // first object that it hits, other than the robot itself, or no value if it hits nothing.
    std::optional<double> ray(Vec origin, double angle, double reach) const;

    // Returns whether the robot overlaps any other object.
    bool overlaps() const;

    b2Body &rigid() { return *rigid_; }
    const b2Body &rigid() const { return *rigid_; }

  private:
    b2Body *rigid_;
};

} // namespace frob::sim
