// Two arrays of eight sonar transducers, that fire one after the other.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "noise.h"
#include "world.h"

namespace frob::sim {

// Each transducer of an array has its turn after this time: a new range from
// each every 320 ms. Sound needs at most 29.2 ms there and back.
constexpr std::int64_t ping_ns = 40'000'000;
static_assert(ping_ns % (2 * step_ns) == 0);

// The order within an array, from its first transducer. Neighbours never follow
// each other, so that none hears the other's ping.
constexpr std::array<std::size_t, 8> firing_order = {0, 4, 1, 5, 2, 6, 3, 7};

struct Echo {
    std::int64_t time_ns;   // at which it arrived
    std::size_t transducer; // 0-15
    double distance;        // m, from the transducer
    Pose from;              // of the transducer in the world when it fired
};

class Sonar {
  public:
    Sonar(const SonarSettings &settings, Noise noise);

    // Fires and listens; called after each physics step, with the time since
    // the start.
    void advance(std::int64_t time_ns, const World &world);

    // The echo of this transducer that arrived since it was last taken, if
    // there was one.
    std::optional<double> take(std::size_t transducer);

    // All echoes that arrived so far, in order of arrival.
    const std::vector<Echo> &echoes() const { return echoes_; }

    // Distance along the cone of a transducer, without noise. `rays` are cast.
    static std::optional<double> range(const World &world, const Pose &transducer, int rays);

  private:
    static constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();

    struct Array {
        std::size_t first;         // of its transducers
        std::int64_t next_ping_ns; // the two arrays take turns
        std::size_t turn = 0;
        std::int64_t arrival_ns = never; // of the echo under way
        Echo echo{};
    };

    void fire(Array &array, std::int64_t time_ns, const World &world);

    SonarSettings settings_;
    Noise noise_;
    std::array<Array, 2> arrays_;
    std::array<std::optional<double>, 16> fresh_;
    std::vector<Echo> echoes_;
};

} // namespace frob::sim
