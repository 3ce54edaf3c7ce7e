#include "own_robot.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

namespace frob::sim {
namespace {

std::vector<Pose> seats_of(const frob_body &table) {
    std::vector<Pose> seats;
    for (std::size_t i = 0; i < table.ranger_count; ++i) {
        const frob_seat &seat = table.rangers[i];
        seats.push_back({{seat.x_m, seat.y_m}, seat.heading_rad});
    }
    return seats;
}

// A disc of even weight: I = m r^2 / 2.
Chassis chassis_of(const frob_body &table) {
    return {
        table.title,
        table.mass_kg,
        table.mass_kg * table.radius_m * table.radius_m / 2.0,
        {0.0, 0.0},
        table.radius_m,
        {},
        table.wheel_radius_m,
        table.wheel_separation_m,
        table.wheel_force_n,
        table.count_m,
        table.battery_v,
        {table.speed_m_s, table.turn_rad_s, table.acceleration_m_s2, table.turn_acceleration_rad_s2},
        {0.0, table.radius_m},
        {0.0, -table.radius_m},
        {seats_of(table), table.half_angle_rad, table.left, table.right, {table.ahead}, "ranger"},
    };
}

SonarRing ring_of(const frob_body &table) {
    std::vector<std::size_t> order(table.ranger_count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    return {std::llround(table.period_s * 1e9), {{order, 0}}, table.nearest_m, table.farthest_m,
            table.resolution_m};
}

} // namespace

OwnBody::OwnBody(const frob_body &described)
    : table(described), chassis(chassis_of(described)), ring(ring_of(described)) {}

OwnRobot::OwnRobot(const OwnBody &body, const Scene &scene, std::uint64_t seed)
    : Robot(body.chassis, scene, seed), described_(body),
      sonar_(body.chassis.range_finders, body.ring, scene.sonar, Noise(seed, sonar_stream)) {}

void OwnRobot::read(std::int64_t time_ns, void *input) {
    std::vector<double> echoes;
    for (std::size_t i = 0; i < described_.table.ranger_count; ++i)
        echoes.push_back(sonar_.take(i).value_or(std::numeric_limits<double>::quiet_NaN()));
    const Pose &believed = odometry_.pose();
    frob_senses senses{};
    senses.time_ns = time_ns;
    senses.x_m = believed.position.x;
    senses.y_m = believed.position.y;
    senses.heading_rad = believed.heading;
    senses.left_m_s = drive_.left_speed();
    senses.right_m_s = drive_.right_speed();
    senses.left_stalled = drive_.left_stalled();
    senses.right_stalled = drive_.right_stalled();
    for (const Vec &at : contacts_.points()) (at.x > 0.0 ? senses.pressed_ahead : senses.pressed_behind) = true;
    senses.battery_v = battery_voltage(time_ns);
    senses.echoes_m = echoes.data();
    std::memset(input, 0, described_.table.input_size);
    described_.table.sense(&senses, input);
}

void OwnRobot::command(const void *output) {
    double forward = 0.0, turn = 0.0;
    described_.table.command(output, &forward, &turn);
    drive_.command(forward, turn);
}

RobotKind own_robot_kind(const OwnBody &body) {
    return {body.table.robot, body.table.input_size, body.table.output_size,
            [&body]() -> const Chassis & { return body.chassis; },
            [&body](const Scene &scene, std::uint64_t seed) {
                return std::make_unique<OwnRobot>(body, scene, seed);
            }};
}

} // namespace frob::sim
