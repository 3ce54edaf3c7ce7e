#include "ros.h"

#include "turtlebot4.h"

namespace frob::sim {

Ros::Ros(const Scene &scene, std::uint64_t seed) : Robot(turtlebot4::chassis(), scene, seed) {}

// Computes the speeds of the base from the wheel speeds, as a real base's ROS node does.
void Ros::read(std::int64_t time_ns, void *into) {
    frob_ros_input input{};
    const Pose &believed = odometry_.pose();
    const double left = drive_.left_speed(), right = drive_.right_speed();
    input.odometry.position.x = believed.position.x;
    input.odometry.position.y = believed.position.y;
    input.odometry.heading = believed.heading;
    input.speed = (left + right) / 2.0;
    input.turning = (right - left) / chassis_.wheel_separation;
    input.battery = battery_voltage(time_ns);
    *static_cast<frob_ros_input *>(into) = input;
}

void Ros::command(std::int64_t time_ns, const void *output) {
    const auto &wanted = *static_cast<const frob_ros_output *>(output);
    drive_.command(time_ns, wanted.forward, wanted.turn);
}

} // namespace frob::sim
