// The infrared of a Create's bumper: how much light comes back from what is near.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "echo.h"
#include "noise.h"
#include "scene.h"

namespace frob::sim
{

class LightBumpers
{
  public:
    LightBumpers(const LightSettings &settings, Noise noise) : settings_(settings), noise_(noise) {}

    // Looks; called after each physics step, with the time since the start.
    void advance(std::int64_t time_ns, const Body &body);

    // From the left to the right, 0 to 4095: a constant divided by the square
    // of the distance.
    const std::array<std::int32_t, 6> &signals() const { return signals_; }

    // What was seen since it was last forgotten, for the picture: of each bumper
    // some ten times a second.
    const std::vector<Echo> &echoes() const { return echoes_; }
    void forget_echoes() { echoes_.clear(); }

  private:
    static constexpr std::int64_t refresh_ns = 15'000'000; // new signals
    static constexpr std::int64_t keep_ns = 105'000'000;   // a new echo for the picture

    LightSettings settings_;
    Noise noise_;
    std::array<std::int32_t, 6> signals_{};
    std::vector<Echo> echoes_;
};

} // namespace frob::sim
