// Tests the parts that are specific to Scout and Create against formulas.
#include <map>

#include <frob/create.h>
#include <frob/scout.h>

#include "check.h"
#include "create2.h"
#include "simulation.h"
#include "super_scout.h"
#include "world_file.h"

using namespace frob::sim;

namespace
{

constexpr std::int64_t second = 1'000'000'000;

Simulation world(const std::string &robot, const std::string &rest)
{
    return { parse_world("robot = \"" + robot + "\"\n[start]\nx = 0\ny = 0\n" + rest, "test"), 1 };
}

template <typename Input>
Input read(Simulation &s)
{
    Input input;
    s.read(&input);
    return input;
}

void drive_scout(Simulation &s, double forward, double turn)
{
    frob_scout_output output{};
    output.forward = forward;
    output.turn = turn;
    s.command(s.time_ns(), &output);
}

void drive_create(Simulation &s, double forward, double turn)
{
    frob_create_output output{};
    output.forward = forward;
    output.turn = turn;
    s.command(s.time_ns(), &output);
}

const char *wall_ahead = "[[wall]]\npoints = [[2, -4], [2, 4]]\nthickness = 0.2\n";

void scout_sonar()
{
    Simulation s =
        world("scout", "[[wall]]\npoints = [[-2, -2], [2, -2], [2, 2], [-2, 2]]\nclosed = true\n");
    s.advance(4 * second);
    std::map<std::size_t, std::int64_t> last;
    bool in_time = true, whole = true;
    for (const Echo &echo : s.robot().echoes()) {
        if (last.count(echo.transducer) != 0)
            in_time = in_time && echo.time_ns - last[echo.transducer] == 640'000'000;
        last[echo.transducer] = echo.time_ns;
        const double inches = echo.distance / 0.0254;
        whole = whole && std::abs(inches - std::round(inches)) < 1e-9;
    }
    check::that(last.size() == 16 && in_time, "each of a Scout's sonars has its turn every 640 ms");
    check::that(whole, "a Scout's distances are whole inches");
    Simulation t = world("scout", wall_ahead);
    t.advance(second);
    check::near(read<frob_scout_input>(t).sonar[0].f0, 1.9 - 0.2, 0.0127 + 1e-9,
                "sonar 0 looks ahead, from the rim");
}

void scout_bumpers()
{
    const char *behind[] = { "[[1, -2], [1, 2]]", "[[-2, 1], [2, 1]]", "[[-1, -2], [-1, 2]]",
                             "[[-2, -1], [2, -1]]" };
    const double heading[] = { 0, 90, 180, 270 };
    // When the robot drives straight into a wall on any side, the bumper on that side is pressed: 0
    // at the front, 3 at the back, and one of two on the sides.
    for (int k = 0; k < 4; ++k) {
        Simulation s = world("scout", std::string("heading_deg = ") + std::to_string(heading[k]) +
                                          "\n[[wall]]\npoints = " + behind[k] + "\n");
        drive_scout(s, 0.3, 0.0);
        s.advance(5 * second);
        const frob_scout_input input = read<frob_scout_input>(s);
        check::that(input.bumpers[0] && !input.bumpers[1] && !input.bumpers[3] && !input.bumpers[5],
                    "driving ahead presses a Scout's bumper 0");
    }
    Simulation s = world("scout", "[[wall]]\npoints = [[-1, -2], [-1, 2]]\n");
    drive_scout(s, -0.3, 0.0);
    s.advance(5 * second);
    check::that(read<frob_scout_input>(s).bumpers[3], "driving back presses bumper 3");
}

void create_light()
{
    Simulation s = world("create", "[[wall]]\npoints = [[0.5, -4], [0.5, 4]]\nthickness = 0.1\n");
    s.advance(second);
    const frob_create_input input = read<frob_create_input>(s);
    for (const int k : { 2, 3 }) {
        const double distance = (0.45 - 0.17425 * std::cos(radians(12))) / std::cos(radians(12));
        check::near(input.light[k], 2.5 / (distance * distance), 1.0,
                    "light falls with the square of the distance");
    }
    check::that(input.light[0] < input.light[1] && input.light[1] < input.light[2],
                "what is aslant is farther");
    Simulation dark = world("create", "");
    dark.advance(second);
    check::that(read<frob_create_input>(dark).light[2] == 0, "nothing near gives no light");
    Simulation near = world("create", "[[wall]]\npoints = [[0.6, -4], [0.6, 4]]\n");
    near.advance(second);
    check::that(!near.robot().echoes().empty(), "a wall near enough to be told is an echo");
    Simulation faint = world("create", "[[wall]]\npoints = [[0.9, -4], [0.9, 4]]\n");
    faint.advance(second);
    check::that(read<frob_create_input>(faint).light[2] > 0 && faint.robot().echoes().empty(),
                "a signal too faint for programs is none");
}

void create_bumps()
{
    const auto bumps = [](const char *wall) {
        Simulation s = world("create", std::string("[[wall]]\npoints = ") + wall + "\n");
        drive_create(s, 0.3, 0.0);
        s.advance(6 * second);
        const frob_create_input input = read<frob_create_input>(s);
        return (input.bumpLeft ? 1 : 0) + (input.bumpRight ? 2 : 0);
    };
    check::that(bumps("[[1, -2], [1, 2]]") == 3, "a wall ahead presses both sides of the bumper");
    check::that(bumps("[[1, 0.1], [1, 2]]") == 1, "its end on the left presses the left side");
    check::that(bumps("[[1, -2], [1, -0.1]]") == 2, "its end on the right the right side");
}

void create_wheels()
{
    Simulation s = world("create", "");
    drive_create(s, 2.0, 0.0);
    s.advance(4 * second);
    check::near(read<frob_create_input>(s).leftWheel, 0.5, 1e-9, "a Create drives 0.5 m/s at most");
    const double way = read<frob_create_input>(s).odometry.position.x;
    const double count = create2::chassis().count;
    check::near(count, 0.00044456, 1e-8, "a count is 0.44456 mm");
    check::near(way / count, std::round(way / count), 1e-6,
                "straight ahead, odometry is whole counts");
    check::near(way, s.body().pose().position.x, 2 * count, "and right to a count");
}

void create_cliffs()
{
    // The edge of the hole is 0.55 m ahead.
    Simulation s = world("create", "[[hole]]\npoints = [[0.55, -1], [2, -1], [2, 1], [0.55, 1]]\n");
    drive_create(s, 0.1, 0.0);
    s.advance(4 * second);
    const frob_create_input before = read<frob_create_input>(s);
    check::that(!before.cliffs[0] && !before.cliffs[1] && !before.cliffs[2] && !before.cliffs[3],
                "there is floor before the edge");
    s.advance(4 * second + second / 2);
    const frob_create_input at_edge = read<frob_create_input>(s);
    check::that(!at_edge.cliffs[0] && at_edge.cliffs[1] && at_edge.cliffs[2] && !at_edge.leftDrop,
                "the front cliff sensors see the edge first");
    s.advance(20 * second);
    const frob_create_input fallen = read<frob_create_input>(s);
    check::that(fallen.leftDrop && fallen.rightDrop && !fallen.obeying,
                "beyond it the wheels hang");
    drive_create(s, -0.1, 0.0);
    s.advance(22 * second);
    check::near(read<frob_create_input>(s).odometry.position.x, fallen.odometry.position.x, 1e-3,
                "and the robot stays there");
}

} // namespace

int main()
{
    scout_sonar();
    scout_bumpers();
    create_light();
    create_bumps();
    create_wheels();
    create_cliffs();
    return check::status();
}
