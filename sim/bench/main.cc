// frob-sim-bench -- what a run costs beyond Box2D itself.
//
//   frob-sim-bench PROGRAM.so WORLD.toml [SECONDS [RATE]]
//
// Runs the program in the simulator, and then the bare physics of that run: the
// same world in Box2D, its robot moved by the velocities that were recorded,
// and the same sonar rays, but no controller, sensors, noise or record. The two
// take turns, and of each the fastest round counts, in processor time, in which
// the machine's other work hardly shows. Prints simulated seconds per second of
// both, and their ratio, one `name: value` a line.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <vector>

#include <frob/pioneer.h>

#include "p3dx.h"
#include "simulation.h"
#include "world_file.h"

extern "C" {
#include <hosts/common/load.h>
}

using namespace frob::sim;

namespace {

constexpr int rounds = 41;
constexpr std::uint64_t seed = 1;

struct Motion {
    b2Vec2 velocity;
    float turn;
};

double seconds_since(std::clock_t start) {
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

// The run as the host makes it without a picture, with `each_step` called after each step of the
// physics. Returns how many seconds it took.
template <typename EachStep>
double run_program(const frob_program &program, const Scene &scene, double duration_s,
                   double rate_hz, EachStep each_step) {
    Simulation simulation(scene, seed, false);
    std::vector<std::max_align_t> state(program.state_size / sizeof(std::max_align_t) + 1);
    const std::clock_t start = std::clock();
    program.reset(state.data());
    std::int64_t before_ns = 0;
    for (std::int64_t k = 0;; ++k) {
        const std::int64_t now_ns = std::llround(static_cast<double>(k) * 1e9 / rate_hz);
        if (static_cast<double>(now_ns) > duration_s * 1e9) break;
        while (simulation.time_ns() + step_ns <= now_ns) {
            simulation.advance(simulation.time_ns() + step_ns);
            each_step(simulation.world().robot());
        }
        frob_pioneer_input input;
        simulation.read(&input);
        frob_pioneer_output output{};
        program.step(state.data(), static_cast<double>(now_ns - before_ns) / 1e9, &input, &output);
        simulation.command(now_ns, &output);
        before_ns = now_ns;
    }
    return seconds_since(start);
}

// The sum of all ranges is returned so that no ray can be left out.
double run_physics(const Scene &scene, const std::vector<Motion> &motions, double &sum) {
    const std::size_t steps_between_pings = static_cast<std::size_t>(p3dx::ring().ping_ns / step_ns);
    World world(scene, p3dx::chassis());
    const auto ping = [&](std::size_t array, std::size_t turn) {
        const std::vector<std::size_t> &order = p3dx::ring().arrays[array].order;
        const Pose &transducer = p3dx::sonars[order[turn % order.size()]];
        sum += nearest_in_cone(world, from_frame(world.robot_pose(), transducer),
                               p3dx::sonar_half_angle, p3dx::sonar_farthest, scene.sonar.rays)
                   .value_or(0.0);
    };
    const std::clock_t start = std::clock();
    for (std::size_t i = 0; i < motions.size(); ++i) {
        world.robot().SetLinearVelocity(motions[i].velocity);
        world.robot().SetAngularVelocity(motions[i].turn);
        world.step();
        const std::size_t step = i + 1, turn = step / steps_between_pings;
        if (step % steps_between_pings == 0) ping(0, turn);
        if (step % steps_between_pings == steps_between_pings / 2) ping(1, turn);
    }
    return seconds_since(start);
}

int bench(const frob_program &program, const Scene &scene, double duration_s, double rate_hz) {
    std::vector<Motion> motions;
    run_program(program, scene, duration_s, rate_hz, [&](const b2Body &robot) {
        motions.push_back({robot.GetLinearVelocity(), robot.GetAngularVelocity()});
    });
    double with_program = 1e30, bare = 1e30, sum = 0.0;
    for (int i = 0; i < rounds; ++i) {
        bare = std::min(bare, run_physics(scene, motions, sum));
        with_program = std::min(with_program, run_program(program, scene, duration_s, rate_hz,
                                                          [](const b2Body &) {}));
    }
    const double simulated = static_cast<double>(motions.size()) * step_s;
    std::printf("bare Box2D: %.0f simulated seconds per second\n", simulated / bare);
    std::printf("with the program: %.0f simulated seconds per second\n", simulated / with_program);
    std::printf("ratio: %.3f\n", bare / with_program);
    return sum >= 0.0 ? 0 : 1;
}

} // namespace

int main(int argc, char **argv) {
    if (argc < 3 || argc > 5) {
        std::fputs("usage: frob-sim-bench PROGRAM.so WORLD.toml [SECONDS [RATE]]\n", stderr);
        return 2;
    }
    const frob_program *program = frob_load(argv[1]);
    if (program == nullptr) return 2;
    const double duration_s = argc > 3 ? std::atof(argv[3]) : 60.0;
    const double rate_hz = argc > 4 ? std::atof(argv[4]) : 50.0;
    if (!(duration_s > 0.0) || !(rate_hz > 0.0) ||
        program->input_size != sizeof(frob_pioneer_input)) {
        std::fputs("error: seconds and rate must be numbers above 0, the program a pioneer's\n",
                   stderr);
        return 2;
    }
    try {
        return bench(*program, read_world_file(argv[2]), duration_s, rate_hz);
    } catch (const std::exception &error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return 2;
    }
}
