// The simulated Super Scout: its sensors and its commands.
#pragma once

#include <frob/scout.h>

#include "robot.h"
#include "sonar.h"

namespace frob::sim {

class Scout : public Robot {
  public:
    Scout(const Scene &scene, std::uint64_t seed);

    void read(std::int64_t time_ns, void *input) override;
    void command(std::int64_t time_ns, const void *output) override;
    const std::vector<Echo> &echoes() const override { return sonar_.echoes(); }
    void forget_echoes() override { sonar_.forget_echoes(); }

  private:
    void look(std::int64_t time_ns, const Body &body) override { sonar_.advance(time_ns, body); }

    Sonar sonar_;
};

} // namespace frob::sim
