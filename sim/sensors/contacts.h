// What touches the robot, and the count of collisions.
#pragma once

#include <cstdint>
#include <vector>

#include "body.h"

namespace frob::sim
{

class Contacts
{
  public:
    // Looks at the contacts; called after each physics step.
    void advance(const Body &body);

    // Where something touches the robot, in the robot's frame.
    const std::vector<Vec> &points() const { return points_; }

    // How often the robot ran into something that stands fast, or another robot
    // and it into each other: then each counts it. Until it has been free of all
    // that for half a second it is the same collision.
    int collisions() const { return collisions_; }

  private:
    static constexpr std::int64_t apart_ns = 500'000'000;

    std::vector<Vec> points_;
    int collisions_ = 0;
    std::int64_t free_ns_ = apart_ns;
};

} // namespace frob::sim
