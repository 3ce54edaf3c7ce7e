// Tests several robots in one world: they see, hit and disturb each other, and each has its own
// noise. Also tests the rays that many robots cast.
#include <string>

#include "check.h"
#include "noise.h"
#include "p3dx.h"
#include "pioneer_controls.h"
#include "ray_fan.h"
#include "simulation.h"
#include "world_file.h"

using namespace frob::sim;

namespace
{

constexpr std::int64_t second = 1'000'000'000;

void see_each_other()
{
    Simulation s(
        parse_world("[[start]]\nx = 0\ny = 0\n[[start]]\nx = 2\ny = 0\nheading_deg = 180\n",
                    "test"),
        1);
    s.advance(second);
    // Transducer 3 points 10 degrees to the left; its cone includes straight ahead.
    for (std::size_t k = 0; k < s.robots(); ++k) {
        double heard = 0.0;
        for (const Echo &echo : s.robot(k).echoes())
            if (echo.transducer == 3)
                heard = echo.distance;
        const double apart = 2.0 - 0.166 - p3dx::chassis().outline[0].x;
        check::that(heard > apart - 0.2 && heard < apart + 0.2,
                    "robot " + std::to_string(k + 1) + " hears the other one");
    }
}

void run_into_each_other()
{
    Simulation s(parse_world("[[start]]\nx = 0\ny = 0\n[[start]]\nx = 2\ny = 0\n"
                             "[[start]]\nx = 0\ny = 3\n",
                             "test"),
                 1);
    command(s, 0, drive(0.5, 0.0));
    s.advance(10 * second);
    check::that(s.robot(0).contacts().collisions() == 1 && s.robot(1).contacts().collisions() == 1,
                "two that run into each other have collided both");
    check::that(s.robot(2).contacts().collisions() == 0, "and a third one has not");
    check::near(s.body(2).pose().position.x, 0.0, 0.0, "each obeys its own commands");
    check::that(s.body(1).pose().position.x > 2.5, "a robot can be pushed");
    check::near(s.believed(1).position.x, s.body(1).pose().position.x, 0.05,
                "and its wheels turn with it");
}

// The readings and poses of robot 0 while others are far away.
std::vector<double> first_of(int robots)
{
    Simulation s(parse_world("[start]\nx = 0\ny = 0\nspacing = 50\ncolumns = 1\ncount = " +
                                 std::to_string(robots) +
                                 "\n[[wall]]\npoints = [[3, -4], [3, 4]]\n[drive]\nslip = 0.05\n"
                                 "[sonar]\nnoise = 0.01\n[odometry]\nheading_noise_deg = 1\n",
                             "test"),
                 7);
    std::vector<double> log;
    for (int k = 0; k < 100; ++k) {
        const std::int64_t now = k * second / 20;
        s.advance(now);
        const frob_pioneer_input input = read(s);
        command(s, now, drive(0.3, 0.2));
        for (const double x : { input.odometry.position.x, input.odometry.heading,
                                input.sonar[3].f0, s.body().pose().position.y })
            log.push_back(x);
    }
    return log;
}

void noise()
{
    check::that(first_of(1) == first_of(3), "more robots do not change what the first one draws");
    check::that(Noise::seed_of_robot(7, 1) != Noise::seed_of_robot(7, 2) &&
                    Noise::seed_of_robot(7, 1) != Noise::seed_of_robot(8, 1),
                "each robot, and each run, has a seed of its own");
}

void blocks()
{
    const Scene scene = parse_world("[[start]]\nx = 1\ny = 2\nheading_deg = 90\ncount = 5\n"
                                    "columns = 2\nspacing = 3\n[[start]]\nx = -9\ny = 0\n",
                                    "test");
    check::that(scene.starts.size() == 6, "a block of five, and one more");
    const Pose last = scene.starts[4].pose;
    check::near(last.position.x, 1.0, 0.0, "the fifth is the first of the third row");
    check::near(last.position.y, 8.0, 0.0, "two spacings up");
    check::near(last.heading, pi / 2, 1e-15, "all of a block look in its direction");
}

std::string mistakes(const std::string &world)
{
    try {
        Simulation(parse_world(world, "w"), 1);
        return "";
    } catch (const WorldFileError &error) {
        return error.what();
    }
}

void wrong_worlds()
{
    check::that(mistakes("[start]\nx = 0\ny = 0\ncount = 2\n") ==
                    "w:1:1: this needs a key `spacing`",
                "several robots are some way apart");
    check::that(mistakes("start = []\n").find("needs a table [start]") != std::string::npos,
                "a world needs a start");
    check::that(mistakes("[[start]]\nx = 0\ny = 0\n[[start]]\nx = 0.2\ny = 0\n") ==
                    "w:1:1: robot 1 starts inside a wall or another object",
                "robots stand beside each other");
}

// Compares rays among walls, boxes at all angles, circles and robots.
void fans()
{
    std::string world = "[start]\nx = -4\ny = -4\ncount = 25\nspacing = 2\n"
                        "[[wall]]\npoints = [[-6, -6], [6, -6], [6, 6], [-6, 6]]\nclosed = true\n"
                        "[[circle]]\ncenter = [1, 1]\nradius = 0.4\n"
                        "[[polygon]]\npoints = [[-1.4, 0.6], [-0.6, 0.6], [-1, 1.4]]\n";
    for (int i = 0; i < 4; ++i)
        world += "[[box]]\ncenter = [" + std::to_string(2 * i - 3) +
                 ", -1]\nsize = [0.5, 0.3]\nangle_deg = " + std::to_string(35 * i) + "\n";
    Simulation s(parse_world(world, "test"), 1);
    for (std::size_t k = 0; k < s.robots(); ++k) {
        const frob_pioneer_output go = drive(0.2, 0.1 * static_cast<double>(k % 7) - 0.3);
        s.command(0, &go, k);
    }
    Noise random(1, 1);
    int same = 0, met = 0, cast = 0;
    for (int i = 0; i < 4000; ++i) {
        if (i % 20 == 0)
            s.advance(s.time_ns() + step_ns);
        const Body &body = s.body(static_cast<std::size_t>(i) % s.robots());
        const Vec origin = { 12 * random.uniform() - 6, 12 * random.uniform() - 6 };
        const double heading = 2 * pi * random.uniform(), half = 1.2 * random.uniform();
        const double reach = 0.1 + 8 * random.uniform();
        const RayFan fan(body, origin, heading, half, reach);
        for (int ray = -2; ray <= 2; ++ray) {
            const double angle = heading + half * ray / 2;
            const std::optional<double> a = fan.ray(angle, reach);
            const std::optional<double> b = body.ray(origin, angle, reach);
            ++cast;
            same += a == b;
            met += a.has_value();
        }
    }
    check::that(same == cast, "a fan's rays end where Box2D's do, to the last bit");
    check::that(met > cast / 4 && met < cast, "some meet something, some do not");
}

} // namespace

int main()
{
    see_each_other();
    run_into_each_other();
    noise();
    blocks();
    wrong_worlds();
    fans();
    return check::status();
}
