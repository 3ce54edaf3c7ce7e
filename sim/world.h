// The physical world: Box2D seen from above, without gravity.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <box2d/box2d.h>

#include "chassis.h"
#include "scene.h"

namespace frob::sim {

// The fixed step of the physics. Fast enough that a robot at full speed moves
// 6 mm; a multiple of it is the time between two pings of a sonar.
constexpr std::int64_t step_ns = 5'000'000;
constexpr double step_s = 0.005;

// The scene's solids and boxes and one robot.
class World {
  public:
    World(const Scene &scene, const Chassis &chassis);

    World(const World &) = delete;
    World &operator=(const World &) = delete;

    // Advances by `step_s`.
    void step();

    // Distance from `origin` to the first thing other than the robot that a ray
    // in direction `angle` meets within `reach`. Nothing: no value.
    std::optional<double> ray(Vec origin, double angle, double reach) const;

    b2Body &robot() { return *robot_; }
    const b2Body &robot() const { return *robot_; }
    b2World &physics() { return physics_; }

    // The robot's true pose; heading in (-pi, pi].
    Pose robot_pose() const;

    // Whether the robot's outline is inside something.
    bool robot_overlaps() const;

    // Poses of the scene's boxes, in the scene's order.
    std::vector<Pose> box_poses() const;

  private:
    b2Body &add_box(const Box &box);

    b2World physics_;
    b2Body *fixed_;
    b2Body *robot_;
    std::vector<b2Body *> boxes_;
};

// Whether a body of this world stands still for ever.
inline bool is_fixed(const b2Body &body) { return body.GetType() == b2_staticBody; }

} // namespace frob::sim
