#include "own_robot.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

namespace frob::sim {
namespace {

// Period of the floor sensors and photocells.
constexpr std::int64_t refresh_ns = 10'000'000;
constexpr double smallest_spot = 0.001; // m

std::vector<Pose> seats_of(const frob_seat *described, std::size_t count) {
    std::vector<Pose> seats;
    for (std::size_t i = 0; i < count; ++i)
        seats.push_back({{described[i].x_m, described[i].y_m}, described[i].heading_rad});
    return seats;
}

std::vector<Vec> spots_of(const frob_body &table) {
    std::vector<Vec> spots;
    for (std::size_t i = 0; i < table.floor_sensor_count; ++i)
        spots.push_back({table.floor_sensors[i].x_m, table.floor_sensors[i].y_m});
    return spots;
}

// The resolution of the speed commands, if the table specifies one: either for the forward speed
// and the turn rate, or for each wheel's speed.
frob_wire wire_of(const frob_body &table) {
    if (table.wheel_step_m_s > 0.0)
        return {true,
                {table.wheel_step_m_s, table.wheel_step_m_s},
                {table.speed_m_s, table.speed_m_s},
                table.wheel_separation_m};
    return {false,
            {table.speed_step_m_s, table.turn_step_rad_s},
            {table.speed_m_s, table.turn_rad_s},
            0.0};
}

// The inertia is that of a uniform disc: I = m r^2 / 2.
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
        {table.speed_m_s, table.turn_rad_s, table.acceleration_m_s2,
         table.turn_acceleration_rad_s2},
        wire_of(table),
        {0.0, table.radius_m},
        {0.0, -table.radius_m},
        {seats_of(table.rangers, table.ranger_count),
         table.half_angle_rad,
         table.left,
         table.right,
         {table.ahead},
         "ranger"},
    };
}

SonarRing ring_of(const frob_body &table) {
    std::vector<std::size_t> order(table.ranger_count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    return {std::llround(table.period_s * 1e9),
            {{order, 0}},
            table.nearest_m,
            table.farthest_m,
            table.resolution_m};
}

} // namespace

OwnBody::OwnBody(const frob_body &described)
    : table(described), chassis(chassis_of(described)), ring(ring_of(described)) {}

OwnRobot::OwnRobot(const OwnBody &body, const Scene &scene, std::uint64_t seed)
    : Robot(body.chassis, scene, seed), described_(body),
      sonar_(body.chassis.range_finders, body.ring, scene.sonar, Noise(seed, sonar_stream)),
      floor_(scene),
      floor_sensors_(spots_of(body.table), std::max(body.table.floor_spot_m, smallest_spot),
                     refresh_ns, scene.floor, Noise(seed, floor_stream)),
      photocells_(seats_of(body.table.photocells, body.table.photocell_count), refresh_ns, scene,
                  Noise(seed, photocell_stream)) {}

void OwnRobot::look(std::int64_t time_ns, const Body &body) {
    sonar_.advance(time_ns, body);
    floor_sensors_.advance(time_ns, body, floor_);
    photocells_.advance(time_ns, body);
}

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
    for (const Vec &at : contacts_.points())
        (at.x > 0.0 ? senses.pressed_ahead : senses.pressed_behind) = true;
    senses.battery_v = battery_voltage(time_ns);
    senses.echoes_m = echoes.data();
    senses.floor = floor_sensors_.seen().data();
    senses.light_lux = photocells_.seen().data();
    std::memset(input, 0, described_.table.input_size);
    described_.table.sense(&senses, input);
}

void OwnRobot::command(std::int64_t time_ns, const void *output) {
    double forward = 0.0, turn = 0.0;
    described_.table.command(output, &forward, &turn);
    drive_.command(time_ns, forward, turn);
}

RobotKind own_robot_kind(const OwnBody &body) {
    return {body.table.robot, body.table.input_size, body.table.output_size,
            [&body]() -> const Chassis & { return body.chassis; },
            [&body](const Scene &scene, std::uint64_t seed) {
                return std::make_unique<OwnRobot>(body, scene, seed);
            }};
}

} // namespace frob::sim
