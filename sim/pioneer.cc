#include "pioneer.h"

#include <algorithm>

#include "p3dx.h"

namespace frob::sim {
namespace {

// Streams of noise, one for each thing that has some.
enum Stream : std::uint64_t { drive_stream = 1, odometry_stream, sonar_stream };

constexpr std::uint8_t event_tag = 1; // data Event a = NoEvent | Event a

} // namespace

Pioneer::Pioneer(const Scene &scene, std::uint64_t seed)
    : battery_(scene.battery), drive_(scene.drive, Noise(seed, drive_stream)),
      odometry_(scene.odometry, Noise(seed, odometry_stream)),
      sonar_(scene.sonar, Noise(seed, sonar_stream)) {}

void Pioneer::sense(std::int64_t time_ns, const World &world) {
    if (time_ns > 0) odometry_.advance(drive_.left_speed(), drive_.right_speed());
    sonar_.advance(time_ns, world);
    bumpers_.advance(world);
}

frob_pioneer_input Pioneer::read(std::int64_t time_ns) {
    frob_pioneer_input input{};
    const Pose &believed = odometry_.pose();
    input.odometry.position.x = believed.position.x;
    input.odometry.position.y = believed.position.y;
    input.odometry.heading = believed.heading;
    input.leftWheel = drive_.left_speed();
    input.rightWheel = drive_.right_speed();
    for (std::size_t i = 0; i < p3dx::sonars.size(); ++i) {
        if (const std::optional<double> distance = sonar_.take(i)) {
            input.sonar[i].tag = event_tag;
            input.sonar[i].f0 = *distance;
        }
    }
    input.frontBumper = bumpers_.front();
    input.rearBumper = bumpers_.rear();
    input.leftStall = drive_.left_stalled();
    input.rightStall = drive_.right_stalled();
    input.battery =
        std::max(0.0, battery_.voltage - battery_.drain * static_cast<double>(time_ns) * 1e-9);
    input.motorsOn = true;
    return input;
}

} // namespace frob::sim
