// Tests the floor: tape and patches in world files, and how sensors measure them.
#include <frob/create.h>

#include "bends.h"
#include "check.h"
#include "floor.h"
#include "simulation.h"
#include "tape_distance.h"
#include "world_file.h"

using namespace frob::sim;

namespace
{

constexpr std::int64_t second = 1'000'000'000;

const std::string start = "robot = \"create\"\n[start]\nx = 0\ny = 0\n";

Simulation world(const std::string &rest, std::uint64_t seed = 1)
{
    return { parse_world(start + rest, "test"), seed };
}

frob_create_input read(Simulation &s)
{
    frob_create_input input;
    s.read(&input);
    return input;
}

void bends()
{
    const std::vector<Vec> ell = { { 0, 0 }, { 2, 0 }, { 2, 3 } };
    const std::vector<Vec> bent = with_bends(ell, false, 0.5);
    bool round = true;
    for (std::size_t i = 1; i + 1 < bent.size(); ++i)
        round = round && std::abs(length(bent[i] - Vec{ 1.5, 0.5 }) - 0.5) < 1e-12;
    check::that(round, "a bend is an arc round a point beside both segments");
    check::near(length(bent[1] - Vec{ 1.5, 0 }), 0.0, 1e-12,
                "it begins where it touches the first");
    check::near(length(bent[bent.size() - 2] - Vec{ 2, 0.5 }), 0.0, 1e-12,
                "and ends where it touches the second");
    const std::vector<Vec> right = with_bends({ { 0, 0 }, { 2, 0 }, { 2, -3 } }, false, 0.5);
    check::near(distance_to_polyline(right, false, { 1.5, -0.5 }), 0.5, 1e-3, "to the right, too");
    const std::vector<Vec> circle =
        with_bends({ { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } }, true, 1.0);
    bool all = true;
    for (const Vec &p : circle)
        all = all && std::abs(length(p) - 1.0) < 1e-12;
    check::that(all, "a square whose bends have half its side is a circle");
    check::that(!corner_without_room(ell, false, 2.0), "two metres have room for this bend");
    check::that(corner_without_room(ell, false, 2.1).has_value(), "but not for a larger one");
    check::that(
        corner_without_room({ { 0, 0 }, { 2, 0 }, { 2, 3 }, { 0, 3 } }, false, 1.6).has_value(),
        "two bends share the segment between them");
    check::that(corner_without_room({ { 0, 0 }, { 2, 0 }, { 1, 0 } }, false, 0.1).has_value(),
                "a line that turns back has no bend");
}

void brightness()
{
    const Scene scene =
        parse_world(start + "[floor]\nreflectance = 0.8\n"
                            "[[tape]]\npoints = [[-1, 2], [1, 2]]\nwidth = 0.1\nreflectance = 0.1\n"
                            "[[patch]]\npoints = [[-2, -2], [2, -2], [2, -1], [-2, -1]]\n"
                            "reflectance = 0.4\n"
                            "[[tape]]\npoints = [[0, -3], [0, 0]]\nwidth = 0.01\nreflectance = 1\n"
                            "[[hole]]\npoints = [[3, 0], [4, 0], [4, 1], [3, 1]]\n",
                    "test");
    const Floor floor(scene);
    const auto at = [&](double x, double y) { return floor.reflectance({ x, y }, 0.02); };
    check::near(at(0, 1), 0.8, 0, "the floor");
    check::near(at(0, 2), 0.1, 1e-12, "tape");
    check::near(at(0, 2.05), 0.45, 1e-12, "half on its edge");
    check::near(at(0, 2.045), 0.1 + 0.25 * 0.7, 1e-12, "a quarter beyond its edge");
    check::near(at(0, 2.06), 0.8, 1e-12, "beside it");
    check::near(at(1.03, 2), 0.1, 1e-12, "its end is round");
    check::near(at(1.07, 2), 0.8, 1e-12, "and is an end");
    check::near(at(1, -1.5), 0.4, 1e-12, "a patch");
    check::near(at(1, -1), 0.6, 1e-12, "half on a patch");
    check::near(at(0, -1.5), 0.7, 1e-12, "tape on a patch that is half as wide as the spot");
    check::near(at(3.5, 0.5), 0.0, 1e-12, "nothing comes back from a hole");
    check::that(floor.has_holes() && floor.ends({ 3.5, 0.5 }) && !floor.ends({ 2.9, 0.5 }),
                "where the floor ends");
}

void create_signals()
{
    // The tape is under the left and the front left sensor.
    Simulation s =
        world("[floor]\nreflectance = 0.9\n[[tape]]\npoints = [[0.07, 0.14], [0.15, 0.04]]\n"
              "reflectance = 0.1\n");
    const frob_create_input input = read(s);
    check::that(
        input.cliffSignals[0] == 150 && input.cliffSignals[1] == 150 &&
            input.cliffSignals[2] == 1350 && input.cliffSignals[3] == 1350,
        "a Create's cliff signals are 1500 times the reflectance, from the left to the right");
    check::that(!input.cliffs[0] && !input.cliffs[1], "tape is no cliff");
    Simulation over = world("[[hole]]\npoints = [[0.1, -1], [1, -1], [1, 1], [0.1, 1]]\n");
    over.advance(15'000'000);
    const frob_create_input edge = read(over);
    check::that(edge.cliffSignals[1] == 0 && edge.cliffs[1] && edge.cliffSignals[0] == 1500 &&
                    !edge.cliffs[0],
                "a cliff has no signal");
    Simulation moves = world("[[tape]]\npoints = [[0.2, -1], [0.2, 1]]\nreflectance = 0\n");
    frob_create_output ahead{};
    ahead.forward = 0.5;
    moves.command(0, &ahead);
    std::int32_t before = read(moves).cliffSignals[1];
    bool on_time = true;
    for (std::int64_t t = 5'000'000; t <= 600'000'000; t += 5'000'000) {
        moves.advance(t);
        const std::int32_t now = read(moves).cliffSignals[1];
        on_time = on_time && (now == before || t % 15'000'000 == 0);
        before = now;
    }
    check::that(on_time, "they are new every 15 ms");
    check::that(moves.body().pose().position.x > 0.1 && moves.robot().contacts().collisions() == 0,
                "tape does not stop a robot");
}

void noise()
{
    const std::string noisy = "[floor]\nnoise = 0.05\n";
    const auto signals = [&](std::uint64_t seed, const std::string &rest) {
        Simulation s = world(noisy + rest, seed);
        std::vector<double> log;
        for (std::int64_t k = 1; k <= 2000; ++k) {
            s.advance(k * 15'000'000);
            log.push_back(read(s).cliffSignals[2]);
        }
        return log;
    };
    const std::vector<double> log = signals(1, "");
    double mean = 0.0, squares = 0.0;
    for (const double x : log)
        mean += x / static_cast<double>(log.size());
    for (const double x : log)
        squares += (x - mean) * (x - mean) / static_cast<double>(log.size());
    check::near(mean, 1500, 10, "noise has no bias");
    check::near(std::sqrt(squares), 75, 5, "and the deviation that was asked for");
    check::that(log == signals(1, "[light]\nnoise = 0.2\n"),
                "the noise of other sensors does not change it");
    check::that(log != signals(2, ""), "another seed gives other noise");
}

void along_the_tape()
{
    const Scene scene =
        parse_world(start + "[[tape]]\npoints = [[1, 1], [3, 1], [3, 2], [1, 2]]\nclosed = true\n"
                            "[measure]\nwhat = \"tape\"\nsettle = 1\n",
                    "test");
    check::near(nearest_on_tape(scene, { 3.1, 1.5 }).along, 2.5, 1e-12,
                "half a metre after the corner");
    check::near(nearest_on_tape(scene, { 0.9, 1.5 }).distance, 0.1, 1e-12,
                "beside the last segment");
    TapeDistance measured(scene, *scene.measure);
    check::that(std::isnan(measured.mean()), "nothing is measured before it settles");
    measured.observe(0, { { 9, 9 }, 0 });
    // One and a half laps, 1 cm outside, in steps of 2 cm.
    std::int64_t time_ns = second;
    const auto go = [&](Vec from, Vec to) {
        const int steps = static_cast<int>(length(to - from) / 0.02);
        for (int i = 0; i <= steps; ++i)
            measured.observe(time_ns += 20'000'000, { from + (1.0 / steps * i) * (to - from), 0 });
    };
    for (int k = 0; k < 2; ++k) {
        go({ 1, 0.99 }, { 3, 0.99 });
        go({ 3.01, 1 }, { 3.01, 2 });
        if (k == 1)
            break;
        go({ 3, 2.01 }, { 1, 2.01 });
        go({ 0.99, 2 }, { 0.99, 1 });
    }
    check::near(measured.way(), 9.0, 0.01, "the way goes on round a closed tape");
    check::near(measured.mean(), 0.01, 1e-9, "and the distance is from its middle");
    check::near(measured.largest(), 0.01, 1e-9, "the largest, too");
    go({ 3.01, 2 }, { 3.01, 1 });
    check::near(measured.way(), 8.0, 0.01, "back is less");
    const double before = measured.way();
    measured.observe(time_ns += 20'000'000, { { 1, 1.5 }, 0 });
    check::near(measured.way(), before, 0, "a leap is no way");
}

void rejects(const std::string &name, const std::string &rest, const std::string &message)
{
    std::string found = "nothing";
    try {
        parse_world(start + rest, "w.toml");
    } catch (const WorldFileError &error) {
        found = error.what();
    }
    check::that(found == message, "world file: " + name);
    if (found != message)
        std::printf("     found %s\n", found.c_str());
}

void mistakes()
{
    rejects("brighter than white", "[floor]\nreflectance = 1.5\n",
            "w.toml:6:15: `reflectance` must be from 0 to 1");
    rejects("tape without a place", "[[tape]]\nwidth = 0.05\n",
            "w.toml:5:1: this needs a key `points`");
    rejects("tape that is too narrow", "[[tape]]\npoints = [[1, 1], [2, 1]]\nwidth = 0.001\n",
            "w.toml:7:9: `width` must be at least 0.01 m");
    rejects("a bend without room", "[[tape]]\npoints = [[1, 1], [2, 1], [2, 2]]\nradius = 1.5\n",
            "w.toml:7:10: there is no room for a bend of this radius at the corner [2, 1]");
    rejects("tape is not thick", "[[tape]]\npoints = [[1, 1], [2, 1]]\nthickness = 0.05\n",
            "w.toml:7:1: unknown key `thickness`");
    rejects("a patch that crosses itself", "[[patch]]\npoints = [[2,2],[3,3],[3,2],[2,3]]\n",
            "w.toml:6:10: the edges of this patch cross or touch");
    rejects("no tape to measure", "[measure]\nwhat = \"tape\"\n",
            "w.toml:5:1: `measure` needs a [[tape]], but this world has none");
    rejects("tape has no side",
            "[[tape]]\npoints = [[1, 1], [2, 1]]\n[measure]\nwhat = \"tape\"\nside = \"left\"\n",
            "w.toml:9:1: unknown key `side`");
    rejects("something else to measure", "[measure]\nwhat = \"line\"\ndistance = 1\n",
            "w.toml:6:8: `what` must be \"wall\", \"tape\" or \"ball\"");
}

} // namespace

int main()
{
    bends();
    brightness();
    create_signals();
    noise();
    along_the_tape();
    mistakes();
    return check::status();
}
