// Tests how the robot moves: the drive, its limits, the floor, and its odometry.
#include <limits>

#include "check.h"
#include "p3dx.h"
#include "pioneer_controls.h"
#include "simulation.h"
#include "world_file.h"

using namespace frob::sim;

namespace
{

constexpr std::int64_t second = 1'000'000'000;

Scene empty_floor(const std::string &settings = "")
{
    return parse_world("[start]\nx = 0\ny = 0\n" + settings, "test");
}

void goes_straight()
{
    Simulation s(empty_floor(), 1);
    command(s, 0, drive(0.5, 0.0));
    s.advance(10 * second);
    const Pose end = s.body().pose();
    // Reaching 0.5 m/s at 0.3 m/s^2 takes 5/3 s, in which the robot covers half the distance.
    check::near(end.position.x, 0.5 * (10.0 - 0.5 * 5.0 / 3.0), 2e-3,
                "goes straight: the distance is that of speed and acceleration");
    check::near(end.position.y, 0.0, 1e-4, "goes straight: stays on its line");
    check::near(end.heading, 0.0, 1e-4, "goes straight: keeps its heading");
}

void turns_on_the_spot()
{
    Simulation s(empty_floor(), 1);
    command(s, 0, drive(0.0, radians(60)));
    s.advance(4 * second);
    command(s, 4 * second, drive(0.0, 0.0));
    s.advance(6 * second);
    const Pose end = s.body().pose();
    // The ramps at both ends cancel out: 60 deg/s for 4 s.
    check::near(end.heading, wrap_angle(radians(240)), 2e-3, "turns on the spot: by rate and time");
    check::near(length(end.position), 0.0, 1e-3, "turns on the spot: stays there");
}

void drives_a_circle()
{
    Simulation s(empty_floor(), 1);
    command(s, 0, drive(0.5 * radians(46), radians(46))); // wheels at 0.4014 and 0.8028
    s.advance(5 * second);
    const Pose start = s.body().pose();
    const Vec center = start.position + 0.5 * direction(start.heading + pi / 2);
    double worst = 0.0;
    for (int i = 1; i <= 100; ++i) {
        s.advance(5 * second + i * second / 10);
        worst = std::max(worst, std::abs(length(s.body().pose().position - center) - 0.5));
    }
    check::near(worst, 0.0, 3e-3, "a circle has the radius v / omega");
}

void accelerates_within_limits()
{
    Simulation s(empty_floor("[drive]\nacceleration = 0.5\nturn_acceleration_deg = 90\n"), 1);
    double v = 0.0, omega = 0.0, most_v = 0.0, most_omega = 0.0;
    for (int i = 1; i <= 1000; ++i) {
        const bool back = i > 500;
        command(s, s.time_ns(), back ? drive(-1.0, -2.0) : drive(1.0, 2.0));
        s.advance(s.time_ns() + step_ns);
        const double v_now = (s.robot().drive().left_speed() + s.robot().drive().right_speed()) / 2;
        const double omega_now = static_cast<double>(s.body().rigid().GetAngularVelocity());
        most_v = std::max(most_v, std::abs(v_now - v) / step_s);
        most_omega = std::max(most_omega, std::abs(omega_now - omega) / step_s);
        v = v_now;
        omega = omega_now;
    }
    check::near(most_v, 0.5, 1e-6, "acceleration is the one that is set, also when reversing");
    check::near(most_omega, radians(90), 1e-3, "so is the acceleration of turning");
}

void limits_commands()
{
    Simulation s(empty_floor(), 1);
    command(s, 0, drive(100.0, -100.0));
    check::near(s.robot().drive().commanded_forward(), 1.2, 0.0,
                "a command is limited to top speed");
    check::near(s.robot().drive().commanded_turn(), -radians(300), 0.0,
                "a turn is limited to top speed");
    command(s, 0, drive(std::numeric_limits<double>::infinity(), 0.0));
    check::near(s.robot().drive().commanded_forward(), 0.0, 0.0, "infinity is rest, as on a robot");
    s.advance(2 * second);
    command(s, s.time_ns(), drive(0.5, std::numeric_limits<double>::quiet_NaN()));
    s.advance(8 * second);
    const b2Vec2 v = s.body().rigid().GetLinearVelocity();
    check::near(static_cast<double>(v.Length()), 0.0, 1e-6, "NaN in any part of a command is rest");
}

void stalls_against_a_wall()
{
    Simulation s(empty_floor("[[wall]]\npoints = [[1, -2], [1, 2]]\nthickness = 0.2\n"), 1);
    command(s, 0, drive(0.5, 0.0));
    s.advance(6 * second);
    const frob_pioneer_input input = read(s);
    const double front = p3dx::body_center + p3dx::body_length / 2;
    check::near(s.body().pose().position.x + front, 0.9, 6e-3,
                "a wall stops the robot at its outline");
    check::that(input.frontBumper && !input.rearBumper, "the front bumper is pressed");
    check::that(input.leftStall && input.rightStall, "both wheels stall");
    check::near(input.leftWheel, 0.0, 0.01, "a stalled wheel stands");
    check::that(s.robot().contacts().collisions() == 1, "pushing on is one collision");
    command(s, s.time_ns(), drive(-0.5, 0.0));
    s.advance(8 * second);
    const frob_pioneer_input away = read(s);
    check::that(!away.frontBumper && !away.leftStall, "it backs away again");
}

void odometry_without_errors()
{
    Simulation s(empty_floor(), 1);
    for (int i = 0; i < 300; ++i) {
        command(s, s.time_ns(), drive(0.4 + 0.2 * std::sin(0.1 * i), std::cos(0.07 * i)));
        s.advance(s.time_ns() + second / 10);
    }
    const Pose truth = s.body().pose(), believed = s.robot().odometry().pose();
    check::near(length(truth.position - believed.position), 0.0, 5e-3,
                "without errors odometry is the truth, after 30 s of curves");
    check::near(wrap_angle(truth.heading - believed.heading), 0.0, 2e-3, "so is its heading");
}

void odometry_starts_at_zero()
{
    Simulation s(parse_world("[start]\nx = 3\ny = 4\nheading_deg = 90\n", "test"), 1);
    const frob_pioneer_input input = read(s);
    check::that(input.odometry.position.x == 0.0 && input.odometry.position.y == 0.0 &&
                    input.odometry.heading == 0.0,
                "odometry starts at zero wherever the robot does");
    command(s, 0, drive(0.5, 0.0));
    s.advance(5 * second);
    check::that(read(s).odometry.position.x > 1.0 && std::abs(read(s).odometry.position.y) < 1e-3,
                "its x is the way the robot looked at the start");
}

void odometry_drifts()
{
    Simulation s(empty_floor("[odometry]\ndistance_error = 0.02\nveer_deg = 2\n"), 1);
    command(s, 0, drive(0.5, 0.0));
    s.advance(10 * second);
    const double driven = s.body().pose().position.x;
    check::near(s.robot().odometry().pose().heading, radians(2) * driven, 1e-3,
                "odometry veers by its setting");
    const double chord = 1.02 * driven;
    check::near(length(s.robot().odometry().pose().position), chord, 0.02 * chord,
                "odometry counts its setting too much");
}

void wheels_slip()
{
    Simulation s(empty_floor("[drive]\nslip = 0.1\n"), 1);
    command(s, 0, drive(0.5, 0.0));
    s.advance(20 * second);
    const double believed = s.robot().odometry().pose().position.x;
    const double driven = length(s.body().pose().position);
    check::near(driven / believed, 0.9, 0.02, "slipping wheels lose the share that is set");
}

} // namespace

int main()
{
    goes_straight();
    turns_on_the_spot();
    drives_a_circle();
    accelerates_within_limits();
    limits_commands();
    stalls_against_a_wall();
    odometry_without_errors();
    odometry_starts_at_zero();
    odometry_drifts();
    wheels_slip();
    return check::status();
}
