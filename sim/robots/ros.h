// The simulated robot for ROS 2 programs: a TurtleBot 4.
#pragma once

#include <frob/ros.h>

#include "robot.h"

namespace frob::sim {

class Ros : public Robot {
  public:
    Ros(const Scene &scene, std::uint64_t seed);

    void read(std::int64_t time_ns, void *input) override;
    void command(std::int64_t time_ns, const void *output) override;

    // Always empty: the robot has no transducers.
    const std::vector<Echo> &echoes() const override { return echoes_; }
    void forget_echoes() override {}

  private:
    void look(std::int64_t, const Body &) override {}

    const std::vector<Echo> echoes_;
};

} // namespace frob::sim
