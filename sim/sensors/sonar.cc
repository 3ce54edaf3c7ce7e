#include "sonar.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace frob::sim {
namespace {

constexpr double speed_of_sound = 343.0; // m/s

} // namespace

Sonar::Sonar(const RangeFinders &seats, const SonarRing &ring, const SonarSettings &settings,
             Noise noise)
    : seats_(seats), ring_(ring), settings_(settings), noise_(noise), fresh_(seats.seats.size()) {
    for (const SonarArray &array : ring.arrays) arrays_.push_back({&array, array.first_ping_ns});
}

void Sonar::fire(Array &array, std::int64_t time_ns, const Body &body) {
    const std::vector<std::size_t> &order = array.transducers->order;
    const std::size_t transducer = order[array.turn];
    array.turn = (array.turn + 1) % order.size();
    array.next_ping_ns += ring_.ping_ns;
    const Pose from = from_frame(body.pose(), seats_.seats[transducer]);
    const std::optional<double> truth =
        nearest_in_cone(body, from, seats_.half_angle, ring_.farthest, settings_.rays);
    // Draws the noise even if the echo is lost, so that the noise of later echoes stays the
    // same.
    const double error = settings_.noise * noise_.normal();
    const bool lost = noise_.uniform() < settings_.dropout;
    if (!truth || lost) return;
    array.arrival_ns = time_ns + static_cast<std::int64_t>(2e9 * *truth / speed_of_sound);
    double heard = std::clamp(*truth + error, ring_.nearest, ring_.farthest);
    if (ring_.resolution > 0.0) heard = ring_.resolution * std::round(heard / ring_.resolution);
    array.echo = {array.arrival_ns, transducer, heard, from};
}

void Sonar::advance(std::int64_t time_ns, const Body &body) {
    for (Array &array : arrays_) {
        if (time_ns >= array.arrival_ns) {
            array.arrival_ns = never;
            fresh_[array.echo.transducer] = array.echo.distance;
            echoes_.push_back(array.echo);
        }
        if (time_ns >= array.next_ping_ns) fire(array, time_ns, body);
    }
}

std::optional<double> Sonar::take(std::size_t transducer) {
    return std::exchange(fresh_[transducer], std::nullopt);
}

} // namespace frob::sim
