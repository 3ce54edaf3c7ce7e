// The simulated Create 2: its sensors and its commands.
#pragma once

#include <frob/create.h>

#include "floor_sensors.h"
#include "light_bumpers.h"
#include "robot.h"

namespace frob::sim {

class Create : public Robot {
  public:
    Create(const Scene &scene, std::uint64_t seed);

    void read(std::int64_t time_ns, void *input) override;

    // A wheel drop stops the robot for good, because the robot has fallen into a hole. A cliff does
    // not stop it: the controller must react to cliffs, as in mode Full.
    void command(std::int64_t time_ns, const void *output) override;

    const std::vector<Echo> &echoes() const override { return light_.echoes(); }
    void forget_echoes() override { light_.forget_echoes(); }

  private:
    void look(std::int64_t time_ns, const Body &body) override;

    const Floor floor_;
    LightBumpers light_;
    FloorSensors floor_sensors_;
    std::array<bool, 4> cliffs_{};
    bool left_drop_ = false, right_drop_ = false, fallen_ = false;
};

} // namespace frob::sim
