#include "sonar.h"

#include <algorithm>
#include <utility>

#include "p3dx.h"

namespace frob::sim {
namespace {

constexpr double speed_of_sound = 343.0; // m/s

} // namespace

Sonar::Sonar(const SonarSettings &settings, Noise noise)
    : settings_(settings), noise_(noise), arrays_{{{0, 0}, {8, ping_ns / 2}}} {}

// The nearest thing anywhere in the cone is what is heard first.
std::optional<double> Sonar::range(const World &world, const Pose &transducer, int rays) {
    std::optional<double> nearest;
    for (int i = 0; i < rays; ++i) {
        const double off =
            rays == 1 ? 0.0 : p3dx::sonar_half_angle * (2.0 * i / (rays - 1) - 1.0);
        const std::optional<double> hit = world.ray(
            transducer.position, transducer.heading + off, nearest.value_or(p3dx::sonar_farthest));
        if (hit) nearest = hit;
    }
    return nearest;
}

void Sonar::fire(Array &array, std::int64_t time_ns, const World &world) {
    const std::size_t transducer = array.first + firing_order[array.turn];
    array.turn = (array.turn + 1) % firing_order.size();
    array.next_ping_ns += ping_ns;
    const Pose from = from_frame(world.robot_pose(), p3dx::sonars[transducer]);
    const std::optional<double> truth = range(world, from, settings_.rays);
    // Drawn in any case: a lost echo does not change the noise of later ones.
    const double error = settings_.noise * noise_.normal();
    const bool lost = noise_.uniform() < settings_.dropout;
    if (!truth || lost) return;
    array.arrival_ns = time_ns + static_cast<std::int64_t>(2e9 * *truth / speed_of_sound);
    const double heard =
        std::clamp(*truth + error, p3dx::sonar_nearest, p3dx::sonar_farthest);
    array.echo = {array.arrival_ns, transducer, heard, from};
}

void Sonar::advance(std::int64_t time_ns, const World &world) {
    for (Array &array : arrays_) {
        if (time_ns >= array.arrival_ns) {
            array.arrival_ns = never;
            fresh_[array.echo.transducer] = array.echo.distance;
            echoes_.push_back(array.echo);
        }
        if (time_ns >= array.next_ping_ns) fire(array, time_ns, world);
    }
}

std::optional<double> Sonar::take(std::size_t transducer) {
    return std::exchange(fresh_[transducer], std::nullopt);
}

} // namespace frob::sim
