// The physical world, which Box2D simulates in two dimensions, seen from above and without gravity.
#pragma once

#include <string>
#include <vector>

#include <box2d/box2d.h>

#include "body.h"
#include "chassis.h"
#include "rolling.h"
#include "scene.h"

namespace frob::sim {

// The physical world with the scene's solids and boxes, and a robot at each start.
class World {
  public:
    World(const Scene &scene, const Chassis &chassis);

    World(const World &) = delete;
    World &operator=(const World &) = delete;

    // Advances by `step_s`.
    void step();

    // The robots in the order of the scene's starts.
    std::vector<Body> &robots() { return robots_; }
    const std::vector<Body> &robots() const { return robots_; }

    b2World &physics() { return physics_; }

    // The poses of the boxes and the places of the balls, in the scene's order.
    std::vector<Pose> box_poses() const;
    std::vector<Vec> ball_places() const;

    // The number of boxes and balls, and the pose of the one with this index. The boxes come first,
    // then the balls, each in the scene's order. A ball's heading has no meaning.
    std::size_t objects() const { return boxes_.size() + balls_.size(); }
    Pose object(std::size_t number) const;

    // The owner of a fixture, for display: "the wall (room.toml, line 12)" or "robot 2".
    const std::string &name_of(const b2Fixture &fixture) const;

  private:
    // adds a name and returns its index in names_
    std::size_t name(const char *kind, const std::string &place);
    b2Body &add_box(const Box &box);
    b2Body &add_ball(const Ball &ball);
    void roll_balls();

    b2World physics_;
    std::vector<std::string> names_;
    b2Body *fixed_;
    std::vector<Body> robots_;
    std::vector<b2Body *> boxes_;
    std::vector<b2Body *> balls_;
    std::vector<Rolling> rolling_; // one for each ball
};

} // namespace frob::sim
