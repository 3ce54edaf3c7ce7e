// Tests the world: its physics, its file, the measurements in it, and that runs are reproducible.
#include "check.h"
#include "p3dx.h"
#include "pioneer_controls.h"
#include "simulation.h"
#include "triangulate.h"
#include "wall_distance.h"
#include "world_file.h"

using namespace frob::sim;

namespace
{

constexpr std::int64_t second = 1'000'000'000;

double kinetic_energy(World &world)
{
    double energy = 0.0;
    for (const b2Body *b = world.physics().GetBodyList(); b != nullptr; b = b->GetNext()) {
        const double v = static_cast<double>(b->GetLinearVelocity().Length());
        const double omega = static_cast<double>(b->GetAngularVelocity());
        energy += 0.5 * static_cast<double>(b->GetMass()) * v * v +
                  0.5 * static_cast<double>(b->GetInertia()) * omega * omega;
    }
    return energy;
}

const char *room_with_boxes = R"(
[start]
x = 0
y = 0
[[wall]]
points = [[-3, -3], [3, -3], [3, 3], [-3, 3]]
closed = true
[[box]]
center = [0.8, 0.1]
size = [0.3, 0.3]
mass = 2
[[box]]
center = [1.3, 0.0]
size = [0.3, 0.3]
mass = 1
)";

void boxes_come_to_rest()
{
    Simulation s(parse_world(room_with_boxes, "test"), 1);
    command(s, 0, drive(0.6, 0.0));
    s.advance(4 * second);
    const std::vector<Pose> pushed = s.world().box_poses();
    check::that(pushed[0].position.x > 1.0, "a box is pushed");
    command(s, 4 * second, drive(-0.3, 0.0));
    s.advance(10 * second);
    const std::vector<Pose> left = s.world().box_poses();
    s.advance(12 * second);
    check::near(length(s.world().box_poses()[0].position - left[0].position), 0.0, 1e-6,
                "a box that is left comes to rest");
    check::that(s.robot().contacts().collisions() == 1, "pushing a box is one collision");
}

void boxes_rub_on_the_floor()
{
    World world(parse_world("[start]\nx = 0\ny = 5\n[[box]]\ncenter = [0, 0]\nsize = [0.4, 0.2]\n"
                            "mass = 3\nfriction = 0.4\n",
                            "test"),
                p3dx::chassis());
    for (b2Body *b = world.physics().GetBodyList(); b != nullptr; b = b->GetNext())
        if (b != &world.robots()[0].rigid())
            b->SetLinearVelocity({ 1.0f, 0.0f });
    for (int i = 0; i < 400; ++i)
        world.step();
    check::near(world.box_poses()[0].position.x, 1.0 / (2 * 0.4 * 9.81), 4e-3,
                "a box slides v^2 / (2 mu g)");
}

// Bodies are thrown at each other, without any drive.
void energy_never_grows()
{
    World world(parse_world(room_with_boxes, "test"), p3dx::chassis());
    float speed = 3.0f;
    for (b2Body *b = world.physics().GetBodyList(); b != nullptr; b = b->GetNext()) {
        b->SetLinearVelocity({ speed, 1.0f - speed });
        b->SetAngularVelocity(2.0f * speed);
        speed = -0.7f * speed;
    }
    double energy = kinetic_energy(world);
    bool grew = false;
    for (int i = 0; i < 2000; ++i) {
        world.step();
        const double now = kinetic_energy(world);
        grew = grew || now > energy * (1 + 1e-5) + 1e-6;
        energy = now;
    }
    check::that(!grew, "no energy comes from nothing");
}

// Readings and poses of a run with all noise on, for bitwise comparison.
std::vector<double> run(std::uint64_t seed)
{
    Simulation s(parse_world(std::string(room_with_boxes) +
                                 "[drive]\nslip = 0.05\n[sonar]\nnoise = 0.01\ndropout = 0.1\n"
                                 "[odometry]\nheading_noise_deg = 1\n",
                             "test"),
                 seed);
    std::vector<double> log;
    for (int k = 0; k < 600; ++k) {
        const std::int64_t now = k * second / 30;
        s.advance(now);
        const frob_pioneer_input input = read(s);
        command(s, now, drive(0.5, std::sin(0.05 * k)));
        for (const double x : { input.odometry.position.x, input.odometry.heading, input.leftWheel,
                                input.sonar[0].f0, input.sonar[3].f0, input.sonar[12].f0,
                                s.body().pose().position.x, s.world().box_poses()[0].heading })
            log.push_back(x);
    }
    return log;
}

void determinism()
{
    check::that(run(1) == run(1), "the same seed gives the same run, bit for bit");
    check::that(run(1) != run(2), "another seed gives another run");
}

void physics_does_not_depend_on_rate()
{
    const auto end = [](int steps) {
        Simulation s(parse_world(room_with_boxes, "test"), 1);
        command(s, 0, drive(0.3, 0.2));
        for (int k = 1; k <= steps; ++k)
            s.advance(k * 5 * second / steps);
        return s.body().pose();
    };
    const Pose a = end(7), b = end(1000);
    check::that(a.position.x == b.position.x && a.heading == b.heading,
                "the physics has steps of its own, whatever the controller's rate");
}

void measure()
{
    const Scene scene = parse_world("[start]\nx = 0\ny = 0\n"
                                    "[[wall]]\npoints = [[-5, 1], [5, 1]]\nthickness = 0.2\n"
                                    "[[polygon]]\npoints = [[2, -1], [3, -1], [3, -2], [2, -2]]\n"
                                    "[measure]\ndistance = 0.5\nsettle = 1\n",
                                    "test");
    check::near(clearance(scene, { 0.0, 0.0 }), 0.9, 1e-12, "clearance is to a wall's surface");
    check::near(clearance(scene, { 1.0, -1.5 }), 1.0, 1e-12, "clearance is to a polygon's edge");
    check::near(clearance(scene, { 2.5, -1.5 }), 0.0, 0.0, "clearance is 0 inside");
    WallDistance measured(scene, p3dx::chassis(), *scene.measure);
    check::that(std::isnan(measured.mean_error()), "nothing is measured before it settles");
    check::near(measured.observe(0, { { 0, 0 }, 0 }), 0.9 - 0.136, 1e-12,
                "the distance counts from the left transducer");
    measured.observe(second, { { 0.0, 0.264 }, 0 });
    measured.observe(2 * second, { { 0.0, 0.164 }, 0 });
    check::near(measured.mean_error(), 0.05, 1e-12, "the mean error is since it settled");
    check::near(measured.largest_error(), 0.1, 1e-12, "so is the largest");
}

void triangles()
{
    const std::vector<Vec> ell = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } };
    double area = 0.0;
    for (const Triangle &t : triangulate(ell))
        area += 0.5 * cross(t[1] - t[0], t[2] - t[0]);
    check::near(area, 3.0, 1e-12, "triangles cover a polygon that is not convex");
    check::that(is_simple(ell), "an L is a simple polygon");
    check::that(!is_simple({ { 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 } }), "a bow tie is not");
}

void rejects(const std::string &name, const std::string &text, const std::string &message)
{
    std::string found = "nothing";
    try {
        Simulation(parse_world(text, "w.toml"), 1);
    } catch (const WorldFileError &error) {
        found = error.what();
    }
    check::that(found == message, "world file: " + name);
    if (found != message)
        std::printf("     found %s\n", found.c_str());
}

const std::string start = "[start]\nx = 0\ny = 0\n";

void mistakes()
{
    rejects("a start is needed", "name = \"x\"\n",
            "w.toml:1:1: a world needs a table [start] with `x` and `y`, the position at which the "
            "robot starts");
    rejects("an unknown key, and the one that was meant",
            start + "[[wall]]\npoints = [[2,0],[2,1]]\nthicknes = 1\n",
            "w.toml:6:1: unknown key `thicknes`; did you mean `thickness`?");
    rejects("a key without its unit", "[start]\nx = 0\ny = 0\nheading = 90\n",
            "w.toml:4:1: unknown key `heading`; did you mean `heading_deg`?");
    rejects("a string for a number", "[start]\nx = \"0\"\ny = 0\n",
            "w.toml:2:5: `x` is a string, but must be a number");
    rejects("a size below zero", start + "[[circle]]\ncenter = [3, 3]\nradius = -1\n",
            "w.toml:6:10: `radius` must be at least 0.01 m");
    rejects("a point with one number", start + "[[wall]]\npoints = [[1, 2], [3]]\n",
            "w.toml:5:19: `points` takes two numbers, [x, y]");
    rejects("a wall of one point", start + "[[wall]]\npoints = [[1, 2]]\n",
            "w.toml:5:10: `points` takes a list of at least 2 points [x, y]");
    rejects("a closed wall whose last point is its first",
            start + "[[wall]]\npoints = [[1, 1], [2, 1], [2, 2], [1, 1]]\nclosed = true\n",
            "w.toml:5:35: this point repeats the first one; remove it, because the last point is "
            "joined to the first");
    rejects("a polygon that crosses itself",
            start + "[[polygon]]\npoints = [[2,2],[3,3],[3,2],[2,3]]\n",
            "w.toml:5:10: the edges of this polygon cross or touch");
    rejects("one table where many may stand", start + "[wall]\npoints = [[1,1],[2,2]]\n",
            "w.toml:4:1: `wall` is a table; write a separate table [[wall]] for each wall");
    rejects("a start inside a wall", start + "[[wall]]\npoints = [[0, -1], [0, 1]]\n",
            "w.toml:1:1: the robot starts inside a wall or another object");
    rejects("a needed key misspelt, once", start + "[[circle]]\ncentre = [3, 3]\nradius = 1\n",
            "w.toml:5:1: unknown key `centre`; did you mean `center`?");
    rejects("several mistakes at once, in the file's order",
            "[start]\nx = true\n[sonar]\nrays = 0\n",
            "w.toml:1:1: this needs a key `y`\n"
            "w.toml:2:5: `x` is true or false, but must be a number\n"
            "w.toml:4:8: `rays` must be a whole number from 1 to 101");
}

// Worlds that no machine could simulate, and impossible robots.
void excesses()
{
    rejects("odometry that is no measurement",
            start + "[odometry]\nveer_deg = 1e6\nturn_error = -2\n",
            "w.toml:5:12: `veer_deg` must be an angle from -360 to 360\n"
            "w.toml:6:14: `turn_error` must be a fraction of the measured value, from -1 to 1");
    std::string heap = start, hall = start;
    for (int i = 0; i < 17; ++i)
        heap += "[[box]]\ncenter = [2, 2]\nsize = [1, 1]\n";
    for (int i = 0; i < 2001; ++i)
        hall += "[[box]]\ncenter = [" + std::to_string(9 + i) + ", 2]\nsize = [0.5, 0.5]\n";
    rejects("a heap of boxes", heap,
            "w.toml:1:1: 17 boxes overlap at [2, 2]; at most 16 may overlap");
    rejects("a hall full of boxes", hall,
            "w.toml:1:1: a world can have at most 2000 boxes, but this one has 2001");
    const auto wall = [](int points, int y) {
        std::string text = "[[wall]]\npoints = [";
        for (int i = 0; i < points; ++i)
            text += "[" + std::to_string(i) + "," + std::to_string(y) + "],";
        return text + "]\n";
    };
    rejects("a wall of very many points", start + wall(20001, 9),
            "w.toml:5:10: `points` takes at most 20000 points, but has 20001");
    rejects("walls of very many points", start + wall(15000, 9) + wall(15000, 12),
            "w.toml:1:1: a world's walls, polygons, holes, patches and tapes can have at most "
            "20000 points, but here they have 30000");
}

// Files that are not TOML at all.
void syntax_mistakes()
{
    const std::string unit =
        "write the number without a unit: lengths are in metres, angles in degrees, "
        "masses in kilograms, times in seconds";
    rejects("a number with a unit", "[start]\nx = 5cm\ny = 0\n", "w.toml:2:6: " + unit);
    rejects("a unit after a blank", "[start]\nx = 1.5 m\n", "w.toml:2:9: " + unit);
    rejects("a unit in brackets", "[start]\nx = 1.5[m]\n", "w.toml:2:8: " + unit);
    rejects("a unit that is no letter", "[start]\nheading_deg = 90°\n", "w.toml:2:17: " + unit);
    rejects("a unit in a list", start + "[[circle]]\ncenter = [1, 2 m]\n", "w.toml:5:16: " + unit);
    rejects("a decimal comma", "[start]\nx = 1,5\n",
            "w.toml:2:6: write the number with a decimal point, not with a comma");
    rejects("a point without digits", "[start]\nx = .5\n",
            "w.toml:2:5: a number needs digits on both sides of the decimal point, as in `0.5`");
    rejects("a computation", "[start]\nx = 1/2\n",
            "w.toml:2:6: expressions are not allowed here: write the result");
    rejects("two keys in a line", "[start]\nx = 1 y = 2\n",
            "w.toml:2:7: write only one key on each line");
    rejects("a key twice", "[start]\nx = 1\nx = 2\n",
            "w.toml:3:5: this is already defined in the file");
    rejects("no value", "[start]\nx =\n", "w.toml:2:4: a value is missing after the `=`");
    rejects("a text without quotation marks", "robot = pioneer\n",
            "w.toml:1:9: put strings in quotation marks: `\"pioneer\"`");
    rejects("a truth of Python's", start + "[[wall]]\nclosed = True\n",
            "w.toml:5:10: write `true` or `false` in lower case");
    rejects("what is no value", "[start]\nx = pi/2\n",
            "w.toml:2:5: this is not a value: write a number, a string in quotation marks, "
            "`true`, `false`, or a list in brackets");
    rejects("a list without a comma", start + "[[wall]]\npoints = [[0, 0] [1, 1]]\n",
            "w.toml:5:18: separate the elements with `,`, and write `]` after the last one");
    rejects("a colon", "[start]\nx: 1\n",
            "w.toml:2:2: write a key, `=` and its value, as in `x = 0.5`");
    rejects("half a bracket", "[start\nx = 1\n",
            "w.toml:1:7: put the name of a table in brackets, as in `[start]` or `[[wall]]`");
    rejects("a comment of C's", "// a room\n",
            "w.toml:1:1: write `key = value`, a table's name such as `[start]`, "
            "or a comment, which begins with `#`");
}

} // namespace

int main()
{
    boxes_come_to_rest();
    boxes_rub_on_the_floor();
    energy_never_grows();
    determinism();
    physics_does_not_depend_on_rate();
    measure();
    triangles();
    mistakes();
    excesses();
    syntax_mistakes();
    return check::status();
}
