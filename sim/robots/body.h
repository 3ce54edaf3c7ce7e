// A robot's body in the world: where it is, and what is around it.
#pragma once

#include <cstdint>
#include <optional>

#include <box2d/box2d.h>

#include "geometry.h"

namespace frob::sim
{

// The fixed step of the physics. Fast enough that a robot at full speed moves
// 6 mm; a multiple of it is the time between two pings of a sonar.
constexpr std::int64_t step_ns = 5'000'000;
constexpr double step_s = 0.005;

class Body
{
  public:
    // The body, which the physics owns, must outlive this.
    explicit Body(b2Body &rigid) : rigid_(&rigid) {}

    // The true pose; heading in (-pi, pi].
    Pose pose() const;

    // Distance from `origin` to the first thing other than the robot itself that
    // a ray in direction `angle` meets within `reach`. Nothing: no value.
    std::optional<double> ray(Vec origin, double angle, double reach) const;

    // Whether the outline is inside something.
    bool overlaps() const;

    b2Body &rigid() { return *rigid_; }
    const b2Body &rigid() const { return *rigid_; }

  private:
    b2Body *rigid_;
};

// What marks a robot's body among the others: Box2D's user data.
inline void mark_as_robot(b2BodyDef &definition)
{
    definition.userData.pointer = 1;
}
inline bool is_robot(b2Body &body)
{
    return body.GetUserData().pointer != 0;
}

} // namespace frob::sim
