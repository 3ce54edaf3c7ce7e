#include "create.h"

#include <algorithm>
#include <cmath>

#include "create2.h"

namespace frob::sim {

namespace {

constexpr std::int64_t refresh_ns = 15'000'000; // period of the cliff sensors

} // namespace

Create::Create(const Scene &scene, std::uint64_t seed)
    : Robot(create2::chassis(), scene, seed), floor_(scene),
      light_(scene.light, Noise(seed, light_stream)),
      floor_sensors_({create2::cliff_places.begin(), create2::cliff_places.end()},
                     create2::cliff_spot, refresh_ns, scene.floor, Noise(seed, floor_stream)) {}

void Create::look(std::int64_t time_ns, const Body &body) {
    light_.advance(time_ns, body);
    floor_sensors_.advance(time_ns, body, floor_);
    if (!floor_.has_holes()) return;
    const Pose pose = body.pose();
    const auto over_hole = [&](Vec place) { return floor_.ends(from_frame(pose, place)); };
    for (std::size_t i = 0; i < cliffs_.size(); ++i)
        cliffs_[i] = over_hole(create2::cliff_places[i]);
    left_drop_ = over_hole({0.0, chassis_.wheel_separation / 2});
    right_drop_ = over_hole({0.0, -chassis_.wheel_separation / 2});
    if (left_drop_ || right_drop_) {
        fallen_ = true;
        drive_.command(time_ns, 0.0, 0.0);
    }
}

void Create::read(std::int64_t time_ns, void *into) {
    frob_create_input input{};
    read_motion(input);
    for (const Vec &at : contacts_.points()) {
        if (at.x <= 0.0) continue; // the bumper covers only the front
        // A contact at the middle presses both switches.
        constexpr double middle = 0.02;
        if (at.y > -middle) input.bumpLeft = true;
        if (at.y < middle) input.bumpRight = true;
    }
    input.leftDrop = left_drop_;
    input.rightDrop = right_drop_;
    std::copy(cliffs_.begin(), cliffs_.end(), input.cliffs);
    for (std::size_t i = 0; i < cliffs_.size(); ++i)
        input.cliffSignals[i] = static_cast<std::int32_t>(std::lround(std::min(
            create2::white_signal * floor_sensors_.seen()[i], double{create2::largest_signal})));
    std::copy(light_.signals().begin(), light_.signals().end(), input.light);
    input.leftOvercurrent = drive_.left_stalled();
    input.rightOvercurrent = drive_.right_stalled();
    input.battery = battery_voltage(time_ns);
    input.charge = 1.0;
    input.obeying = !fallen_;
    *static_cast<frob_create_input *>(into) = input;
}

void Create::command(std::int64_t time_ns, const void *output) {
    const auto &wanted = *static_cast<const frob_create_output *>(output);
    if (!fallen_) drive_.command(time_ns, wanted.forward, wanted.turn);
}

} // namespace frob::sim
