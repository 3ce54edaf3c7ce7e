// Rings of sonar transducers that fire in turn.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "body.h"
#include "chassis.h"
#include "echo.h"
#include "noise.h"
#include "scene.h"
#include "sonar_ring.h"

namespace frob::sim {

class Sonar {
  public:
    // `seats` and `ring` must outlive the sonars.
    Sonar(const RangeFinders &seats, const SonarRing &ring, const SonarSettings &settings,
          Noise noise);

    // Fires and listens. Must be called after each physics step, with the time since the start.
    void advance(std::int64_t time_ns, const Body &body);

    // Returns the echo that this transducer has received since the last call, if any.
    std::optional<double> take(std::size_t transducer);

    // Turns the echoes that `take` returns for all transducers into events of a robot's input.
    template <typename Event, std::size_t count>
    void take_all(Event (&events)[count]) {
        constexpr std::uint8_t occurs = 1; // the tag of `Event` in data Event a = NoEvent | Event a
        for (std::size_t i = 0; i < count; ++i)
            if (const std::optional<double> distance = take(i)) {
                events[i].tag = occurs;
                events[i].f0 = *distance;
            }
    }

    // All echoes that have arrived since the last call to `forget_echoes`, in order of arrival.
    const std::vector<Echo> &echoes() const { return echoes_; }
    void forget_echoes() { echoes_.clear(); }

  private:
    static constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();

    struct Array {
        const SonarArray *transducers;
        std::int64_t next_ping_ns;
        std::size_t turn = 0;
        std::int64_t arrival_ns = never; // arrival time of the echo in flight
        Echo echo{};
    };

    void fire(Array &array, std::int64_t time_ns, const Body &body);

    const RangeFinders &seats_;
    const SonarRing &ring_;
    SonarSettings settings_;
    Noise noise_;
    std::vector<Array> arrays_;
    std::vector<std::optional<double>> fresh_;
    std::vector<Echo> echoes_;
};

} // namespace frob::sim
