// frob-sim-bench -- measures the overhead of a run over bare Box2D.
//
//   frob-sim-bench PROGRAM.so WORLD.toml [SECONDS [RATE [ROUNDS]]]
//
// Runs the program in the simulator, on each of the world's robots, and then the bare physics of
// that run: the same world in Box2D, its robots moved by the recorded velocities, and the same
// sonar rays, but no controllers, sensors, noise or recording. It runs the bare physics in two
// ways: with Box2D's own ray casts, each through the whole world, and like the simulator, which
// looks up the objects in each cone only once (see ray_fan.h).
//
// The kinds of runs alternate, and only the fastest round of each kind counts. Times are CPU times,
// which other processes on the machine hardly affect. Prints the simulated seconds per second of
// each kind of run, and their ratios, one `name: value` per line.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <vector>

#include <frob/pioneer.h>

#include "echo.h"
#include "p3dx.h"
#include "simulation.h"
#include "world_file.h"

extern "C" {
#include <hosts/common/load.h>
}

using namespace frob::sim;

namespace {

constexpr std::uint64_t seed = 1;

struct Motion {
    b2Vec2 velocity;
    float turn;
};

double seconds_since(std::clock_t start) {
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

// Runs the simulation as the host does when it draws no picture, and calls `each_step` after each
// step of the physics. Returns the time it took, in seconds.
template <typename EachStep>
double run_program(const frob_program &program, const Scene &scene, double duration_s,
                   double rate_hz, EachStep each_step) {
    Simulation simulation(scene, seed, false);
    const std::size_t robots = simulation.robots();
    const std::size_t room = program.state_size / sizeof(std::max_align_t) + 1;
    std::vector<std::max_align_t> states(room * robots);
    const std::clock_t start = std::clock();
    for (std::size_t k = 0; k < robots; ++k)
        program.reset(&states[room * k], program.default_params);
    std::int64_t before_ns = 0;
    for (std::int64_t instant = 0;; ++instant) {
        const std::int64_t now_ns = std::llround(static_cast<double>(instant) * 1e9 / rate_hz);
        if (static_cast<double>(now_ns) > duration_s * 1e9) break;
        while (simulation.time_ns() + step_ns <= now_ns) {
            simulation.advance(simulation.time_ns() + step_ns);
            each_step(simulation.world().robots());
        }
        for (std::size_t k = 0; k < robots; ++k) {
            frob_pioneer_input input;
            simulation.read(&input, k);
            frob_pioneer_output output{};
            program.step(&states[room * k], program.default_params, now_ns - before_ns,
                         static_cast<double>(now_ns - before_ns) / 1e9, &input, &output);
            simulation.command(now_ns, &output, k);
        }
        before_ns = now_ns;
    }
    return seconds_since(start);
}

// Returns the distance to the nearest object in a cone, using only Box2D's rays.
double nearest_by_box2d(const Body &body, const Pose &from, int rays) {
    double nearest = p3dx::sonar_farthest;
    for (int i = 0; i < rays; ++i) {
        const double off = p3dx::sonar_half_angle * (rays == 1 ? 0.0 : 2.0 * i / (rays - 1) - 1.0);
        nearest = body.ray(from.position, from.heading + off, nearest).value_or(nearest);
    }
    return nearest;
}

double nearest_by_simulator(const Body &body, const Pose &from, int rays) {
    return nearest_in_cone(body, from, p3dx::sonar_half_angle, p3dx::sonar_farthest, rays)
        .value_or(p3dx::sonar_farthest);
}

// Replays `motions`, which contains each robot's velocities, step by step. Adds up all ranges, so
// that the compiler cannot optimize the rays away.
template <typename Nearest>
double run_physics(const Scene &scene, const std::vector<Motion> &motions, Nearest nearest,
                   double &sum) {
    const std::size_t steps_between_pings =
        static_cast<std::size_t>(p3dx::ring().ping_ns / step_ns);
    World world(scene, p3dx::chassis());
    std::vector<Body> &robots = world.robots();
    const auto ping = [&](std::size_t array, std::size_t turn) {
        const std::vector<std::size_t> &order = p3dx::ring().arrays[array].order;
        const Pose &transducer = p3dx::sonars[order[turn % order.size()]];
        for (const Body &robot : robots)
            sum += nearest(robot, from_frame(robot.pose(), transducer), scene.sonar.rays);
    };
    const std::clock_t start = std::clock();
    for (std::size_t i = 0; i < motions.size() / robots.size(); ++i) {
        for (std::size_t k = 0; k < robots.size(); ++k) {
            const Motion &motion = motions[i * robots.size() + k];
            robots[k].rigid().SetLinearVelocity(motion.velocity);
            robots[k].rigid().SetAngularVelocity(motion.turn);
        }
        world.step();
        const std::size_t step = i + 1, turn = step / steps_between_pings;
        if (step % steps_between_pings == 0) ping(0, turn);
        if (step % steps_between_pings == steps_between_pings / 2) ping(1, turn);
    }
    return seconds_since(start);
}

int bench(const frob_program &program, const Scene &scene, double duration_s, double rate_hz,
          int rounds) {
    std::vector<Motion> motions;
    run_program(program, scene, duration_s, rate_hz, [&](const std::vector<Body> &robots) {
        for (const Body &robot : robots)
            motions.push_back(
                {robot.rigid().GetLinearVelocity(), robot.rigid().GetAngularVelocity()});
    });
    double with_program = 1e30, bare = 1e30, by_cone = 1e30, sum = 0.0;
    for (int i = 0; i < rounds; ++i) {
        bare = std::min(bare, run_physics(scene, motions, nearest_by_box2d, sum));
        by_cone = std::min(by_cone, run_physics(scene, motions, nearest_by_simulator, sum));
        with_program = std::min(with_program, run_program(program, scene, duration_s, rate_hz,
                                                          [](const std::vector<Body> &) {}));
    }
    const double simulated = static_cast<double>(motions.size() / scene.starts.size()) * step_s;
    std::printf("robots: %zu\n", scene.starts.size());
    std::printf("bare Box2D: %.4g simulated seconds per second\n", simulated / bare);
    std::printf("bare, one look-up per cone: %.4g simulated seconds per second\n",
                simulated / by_cone);
    std::printf("with the program: %.4g simulated seconds per second\n", simulated / with_program);
    std::printf("ratio: %.3f\n", bare / with_program);
    std::printf("ratio, one look-up per cone: %.3f\n", by_cone / with_program);
    return sum >= 0.0 ? 0 : 1;
}

} // namespace

int main(int argc, char **argv) {
    if (argc < 3 || argc > 6) {
        std::fputs("usage: frob-sim-bench PROGRAM.so WORLD.toml [SECONDS [RATE [ROUNDS]]]\n",
                   stderr);
        return 2;
    }
    const frob_program *program = frob_load(argv[1]);
    if (program == nullptr) return 2;
    const double duration_s = argc > 3 ? std::atof(argv[3]) : 60.0;
    const double rate_hz = argc > 4 ? std::atof(argv[4]) : 50.0;
    const int rounds = argc > 5 ? std::atoi(argv[5]) : 41;
    if (!(duration_s > 0.0) || !(rate_hz > 0.0) || rounds < 1 ||
        program->input_size != sizeof(frob_pioneer_input)) {
        std::fputs("error: seconds, rate and rounds must be above 0, and the program must drive a "
                   "pioneer\n",
                   stderr);
        return 2;
    }
    try {
        return bench(*program, read_world_file(argv[2]), duration_s, rate_hz, rounds);
    } catch (const std::exception &error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return 2;
    }
}
