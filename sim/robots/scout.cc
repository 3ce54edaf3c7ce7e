#include "scout.h"

#include <cmath>

#include "super_scout.h"

namespace frob::sim {
namespace {

constexpr std::size_t bumpers = super_scout::bumper_count;
static_assert(sizeof(frob_scout_input::bumpers) == bumpers * sizeof(bool));

// The bumper that a contact presses. Each bumper covers a sixth of the circumference; the first is
// centred on the front, and the others follow counter-clockwise.
std::size_t bumper_at(const Vec &at) {
    const double sixths = std::atan2(at.y, at.x) / (2 * pi / bumpers);
    return static_cast<std::size_t>(std::lround(sixths) + static_cast<long>(bumpers)) % bumpers;
}

} // namespace

Scout::Scout(const Scene &scene, std::uint64_t seed)
    : Robot(super_scout::chassis(), scene, seed),
      sonar_(super_scout::chassis().range_finders, super_scout::ring(), scene.sonar,
             Noise(seed, sonar_stream)) {}

void Scout::read(std::int64_t time_ns, void *into) {
    frob_scout_input input{};
    read_motion(input);
    sonar_.take_all(input.sonar);
    for (const Vec &at : contacts_.points()) input.bumpers[bumper_at(at)] = true;
    input.battery = battery_voltage(time_ns);
    *static_cast<frob_scout_input *>(into) = input;
}

void Scout::command(std::int64_t time_ns, const void *output) {
    const auto &wanted = *static_cast<const frob_scout_output *>(output);
    drive_.command(time_ns, wanted.forward, wanted.turn);
}

} // namespace frob::sim
