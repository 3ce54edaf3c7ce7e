#include "pioneer.h"

#include "p3dx.h"

namespace frob::sim {

Pioneer::Pioneer(const Scene &scene, std::uint64_t seed)
    : Robot(p3dx::chassis(), scene, seed),
      sonar_(p3dx::chassis().range_finders, p3dx::ring(), scene.sonar, Noise(seed, sonar_stream)) {}

// A contact in front of the body's centre presses the front bumper; one behind it presses the rear
// bumper.
void Pioneer::read(std::int64_t time_ns, void *into) {
    frob_pioneer_input input{};
    read_motion(input);
    sonar_.take_all(input.sonar);
    for (const Vec &at : contacts_.points())
        (at.x > p3dx::body_center ? input.frontBumper : input.rearBumper) = true;
    input.leftStall = drive_.left_stalled();
    input.rightStall = drive_.right_stalled();
    input.battery = battery_voltage(time_ns);
    input.motorsOn = true;
    *static_cast<frob_pioneer_input *>(into) = input;
}

void Pioneer::command(std::int64_t time_ns, const void *output) {
    const auto &wanted = *static_cast<const frob_pioneer_output *>(output);
    drive_.command(time_ns, wanted.forward, wanted.turn);
}

} // namespace frob::sim
