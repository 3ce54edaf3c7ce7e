// The bumpers in front and behind, and the count of collisions.
#pragma once

#include <cstdint>

#include "world.h"

namespace frob::sim {

class Bumpers {
  public:
    // Looks at the contacts; called after each physics step.
    void advance(const World &world);

    bool front() const { return front_; }
    bool rear() const { return rear_; }

    // How often the robot ran into something that stands fast. Until it has
    // been free of it for half a second it is the same collision.
    int collisions() const { return collisions_; }

  private:
    static constexpr std::int64_t apart_ns = 500'000'000;

    bool front_ = false, rear_ = false;
    int collisions_ = 0;
    std::int64_t free_ns_ = apart_ns;
};

} // namespace frob::sim
