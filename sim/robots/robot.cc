#include "robot.h"

#include <algorithm>

#include "create.h"
#include "create2.h"
#include "p3dx.h"
#include "pioneer.h"
#include "ros.h"
#include "scout.h"
#include "super_scout.h"
#include "turtlebot4.h"

namespace frob::sim {
namespace {

template <typename Kind>
std::unique_ptr<Robot> make(const Scene &scene, std::uint64_t seed) {
    return std::make_unique<Kind>(scene, seed);
}

} // namespace

Robot::Robot(const Chassis &chassis, const Scene &scene, std::uint64_t seed)
    : chassis_(chassis), battery_(scene.battery),
      drive_(chassis, scene.drive, Noise(seed, drive_stream)),
      odometry_(chassis, scene.odometry, Noise(seed, odometry_stream)) {}

void Robot::sense(std::int64_t time_ns, const Body &body) {
    if (time_ns > 0) odometry_.advance(drive_.left_speed(), drive_.right_speed());
    look(time_ns, body);
    contacts_.advance(body);
}

double Robot::battery_voltage(std::int64_t time_ns) const {
    return std::max(0.0, battery_.voltage.value_or(chassis_.battery) -
                             battery_.drain * static_cast<double>(time_ns) * 1e-9);
}

const std::vector<RobotKind> &robot_kinds() {
    static const std::vector<RobotKind> kinds = {
        {"pioneer", sizeof(frob_pioneer_input), sizeof(frob_pioneer_output), p3dx::chassis,
         make<Pioneer>},
        {"scout", sizeof(frob_scout_input), sizeof(frob_scout_output), super_scout::chassis,
         make<Scout>},
        {"create", sizeof(frob_create_input), sizeof(frob_create_output), create2::chassis,
         make<Create>},
        {"ros", sizeof(frob_ros_input), sizeof(frob_ros_output), turtlebot4::chassis, make<Ros>,
         true},
    };
    return kinds;
}

const RobotKind *robot_kind(const std::string &name) {
    for (const RobotKind &kind : robot_kinds())
        if (name == kind.name) return &kind;
    return nullptr;
}

} // namespace frob::sim
