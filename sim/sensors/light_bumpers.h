// The infrared sensors in a Create's bumper, which measure the light that nearby objects reflect.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "echo.h"
#include "noise.h"
#include "scene.h"

namespace frob::sim {

class LightBumpers {
  public:
    LightBumpers(const LightSettings &settings, Noise noise) : settings_(settings), noise_(noise) {}

    // Updates the signals; called after each physics step, with the time since the start.
    void advance(std::int64_t time_ns, const Body &body);

    // Signals from left to right, 0 to 4095: a constant divided by the squared distance.
    const std::array<std::int32_t, 6> &signals() const { return signals_; }

    // The echoes since the last call to `forget_echoes`, for the picture: approximately ten a
    // second for each sensor.
    const std::vector<Echo> &echoes() const { return echoes_; }
    void forget_echoes() { echoes_.clear(); }

  private:
    static constexpr std::int64_t refresh_ns = 15'000'000; // period of the signals
    static constexpr std::int64_t keep_ns = 105'000'000;   // period of the echoes for the picture

    LightSettings settings_;
    Noise noise_;
    std::array<std::int32_t, 6> signals_{};
    std::vector<Echo> echoes_;
};

} // namespace frob::sim
