// Tests the echoes of the sonars, against geometry.
#include <map>

#include "check.h"
#include "p3dx.h"
#include "pioneer_controls.h"
#include "simulation.h"
#include "world_file.h"

using namespace frob::sim;

namespace
{

constexpr std::int64_t second = 1'000'000'000;

Scene with_start(const std::string &rest)
{
    return parse_world("[start]\nx = 0\ny = 0\n" + rest, "test");
}

// The distances of a transducer's echoes in the first `time_ns`, with the robot at rest.
std::vector<double> echoes(const Scene &scene, std::size_t transducer, std::int64_t time_ns,
                           std::uint64_t seed = 1)
{
    Simulation s(scene, seed);
    s.advance(time_ns);
    std::vector<double> result;
    for (const Echo &echo : s.robot().echoes())
        if (echo.transducer == transducer)
            result.push_back(echo.distance);
    return result;
}

const char *wall_ahead = "[[wall]]\npoints = [[2, -4], [2, 4]]\nthickness = 0.2\n";

void distances()
{
    const Scene scene = with_start(wall_ahead);
    // Transducer 3 points 10 degrees to the left; its cone includes straight ahead, where the wall
    // is nearest.
    const std::vector<double> ahead = echoes(scene, 3, second);
    check::that(ahead.size() == 3, "a transducer is heard every 320 ms");
    check::near(ahead.empty() ? 0.0 : ahead[0], 1.9 - 0.166, 1e-3,
                "a wall in the cone is as far as its nearest point");
    // Transducer 2 points 30 degrees to the left; the edge of its cone nearest to the wall's normal
    // is at 18 degrees.
    const std::vector<double> aslant = echoes(scene, 2, second);
    check::near(aslant.empty() ? 0.0 : aslant[0], (1.9 - 0.148) / std::cos(radians(18)), 1e-3,
                "a wall aslant is heard by the cone's edge");
    check::that(echoes(scene, 12, second).empty(), "nothing behind gives no echo");
}

void ranges()
{
    check::that(echoes(with_start("[[wall]]\npoints = [[5.4, -9], [5.4, 9]]\n"), 3, second).empty(),
                "what is beyond 5 m gives no echo");
    const std::vector<double> near =
        echoes(with_start("[[circle]]\ncenter = [0.33, 0.03]\nradius = 0.1\n"), 3, second);
    check::near(near.empty() ? 0.0 : near[0], 0.1, 0.0, "what is nearer than 0.1 m reads 0.1 m");
    const std::vector<double> beside =
        echoes(with_start("[[box]]\ncenter = [0.069, 1]\nsize = [0.4, 0.4]\n"), 0, second);
    check::near(beside.empty() ? 0.0 : beside[0], 0.8 - 0.136, 1e-3, "boxes are heard, too");
}

void firing()
{
    Simulation s(with_start("[[wall]]\npoints = [[-2, -2], [2, -2], [2, 2], [-2, 2]]\n"
                            "closed = true\n"),
                 1);
    std::map<std::size_t, std::int64_t> last;
    bool in_time = true;
    int heard = 0;
    s.advance(2 * second);
    for (const Echo &echo : s.robot().echoes()) {
        ++heard;
        if (last.count(echo.transducer) != 0)
            in_time = in_time && echo.time_ns - last[echo.transducer] == 8 * p3dx::ring().ping_ns;
        last[echo.transducer] = echo.time_ns;
    }
    check::that(last.size() == 16, "all transducers are heard in a room");
    check::that(in_time, "each has its turn every 320 ms");
    check::that(heard >= 96 && heard <= 100, "one of each array every 40 ms");
}

void events()
{
    Simulation s(with_start(wall_ahead), 1);
    int occurrences = 0;
    for (int k = 1; k <= 200; ++k) {
        s.advance(k * second / 50);
        occurrences += read(s).sonar[3].tag == 1 ? 1 : 0;
    }
    check::that(occurrences == 12, "an echo is an event of one instant only");
}

void arrival()
{
    Simulation s(with_start(wall_ahead), 1);
    s.advance(second);
    for (const Echo &echo : s.robot().echoes())
        if (echo.transducer == 3) {
            const std::int64_t fired = echo.time_ns / p3dx::ring().ping_ns * p3dx::ring().ping_ns;
            check::near(static_cast<double>(echo.time_ns - fired) * 1e-9, 2 * echo.distance / 343.0,
                        1e-6, "sound takes its time, there and back");
            return;
        }
    check::that(false, "sound takes its time, there and back");
}

void noise()
{
    const Scene noisy = with_start(std::string(wall_ahead) + "[sonar]\nnoise = 0.02\n");
    const std::vector<double> once = echoes(noisy, 3, 600 * second);
    double sum = 0.0, squares = 0.0;
    for (const double d : once) {
        sum += d - (1.9 - 0.166);
        squares += (d - (1.9 - 0.166)) * (d - (1.9 - 0.166));
    }
    const double n = static_cast<double>(once.size());
    check::near(sum / n, 0.0, 0.002, "noise has no bias");
    check::near(std::sqrt(squares / n), 0.02, 0.001, "noise has the deviation that is set");
    check::that(once == echoes(noisy, 3, 600 * second), "the same seed gives the same noise");
    check::that(once != echoes(noisy, 3, 600 * second, 2), "another seed gives other noise");
    const Scene lossy = with_start(std::string(wall_ahead) + "[sonar]\ndropout = 0.25\n");
    check::near(static_cast<double>(echoes(lossy, 3, 600 * second).size()) / n, 0.75, 0.04,
                "dropouts lose the share that is set");
}

void generator()
{
    // splitmix64 uses integers only, so these values are the same on every machine.
    Noise noise(1, 1);
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < 100000; ++i) {
        const double x = noise.normal();
        sum += x;
        squares += x * x;
    }
    check::near(sum / 1e5, 0.0, 0.01, "normal numbers have mean 0");
    check::near(squares / 1e5, 1.0, 0.02, "normal numbers have variance 1");
    check::that(Noise(7, 1).uniform() != Noise(7, 2).uniform() &&
                    Noise(7, 2).uniform() != Noise(8, 1).uniform(),
                "streams and seeds are different noise");
}

} // namespace

int main()
{
    distances();
    ranges();
    firing();
    events();
    arrival();
    noise();
    generator();
    return check::status();
}
