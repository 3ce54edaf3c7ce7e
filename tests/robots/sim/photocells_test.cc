// Tests the photocells and floor sensors of a user-defined robot.
#include <cstring>

#include <frob/body.h>

#include "check.h"
#include "own_robot.h"
#include "simulation.h"
#include "world_file.h"

using namespace frob::sim;

namespace
{

constexpr std::int64_t second = 1'000'000'000;

// Its sensors: two photocells, to the left and ahead, and a floor sensor.
struct Input {
    double left, ahead, floor;
};

const frob_seat ranger = { 0.1, 0.0, 0.0 };
const frob_spot spot = { 0.05, 0.02 };
const frob_seat cells[] = { { 0.0, 0.0, radians(90) }, { 0.0, 0.0, 0.0 } };

void sense(const frob_senses *senses, void *into)
{
    const Input input = { senses->light_lux[0], senses->light_lux[1], senses->floor[0] };
    std::memcpy(into, &input, sizeof input);
}

void sense_nothing(const frob_senses *, void *) {}

void command(const void *, double *forward, double *turn)
{
    *forward = *turn = 0.0;
}

frob_body table()
{
    frob_body body{};
    body.robot = "seer";
    body.title = "Seer";
    body.input_size = sizeof(Input);
    body.output_size = 1;
    body.mass_kg = 1.0;
    body.radius_m = 0.1;
    body.wheel_radius_m = 0.02;
    body.wheel_separation_m = 0.1;
    body.wheel_force_n = 1.0;
    body.battery_v = 5.0;
    body.speed_m_s = body.turn_rad_s = body.acceleration_m_s2 = body.turn_acceleration_rad_s2 = 1.0;
    body.rangers = &ranger;
    body.ranger_count = 1;
    body.nearest_m = 0.1;
    body.farthest_m = 1.0;
    body.period_s = 0.1;
    body.sense = sense;
    body.command = command;
    body.floor_sensors = &spot;
    body.floor_sensor_count = 1;
    body.floor_spot_m = 0.01;
    body.photocells = cells;
    body.photocell_count = 2;
    return body;
}

// A robot at the origin that faces along x.
class Seer
{
  public:
    explicit Seer(const std::string &rest, std::uint64_t seed = 1)
        : table_(table()), body_(table_), kind_(own_robot_kind(body_)),
          simulation_(parse_world("[start]\nx = 0\ny = 0\n" + rest, "test"), seed, false, &kind_)
    {
    }

    Input at(std::int64_t time_ns)
    {
        Input input;
        simulation_.advance(time_ns);
        simulation_.read(&input);
        return input;
    }

  private:
    frob_body table_;
    OwnBody body_;
    RobotKind kind_;
    Simulation simulation_;
};

Input seen(const std::string &rest)
{
    return Seer(rest).at(0);
}

void light_of_lamps()
{
    check::near(seen("").ahead, 0.0, 0, "without a lamp it is dark");
    // The lamp is 2 m ahead and 1.5 m up, so 2.5 m away: E = I cos(a) / d^2 with cos(a) = 2 / 2.5.
    const std::string lamp = "[[lamp]]\nposition = [2, 0]\nheight = 1.5\nintensity = 100\n";
    check::near(seen(lamp).ahead, 100 * 0.8 / 6.25, 1e-9,
                "a lamp ahead, by the square of the distance");
    check::near(seen(lamp).left, 0.0, 1e-9, "a cell does not see what is square to it");
    check::near(seen("[[lamp]]\nposition = [-2, 0]\n").ahead, 0.0, 0, "nor what is behind it");
    const Input aslant = seen("[[lamp]]\nposition = [1, 1]\nheight = 0.5\nintensity = 60\n");
    check::near(aslant.left, 60 / std::pow(2.25, 1.5), 1e-9,
                "a lamp between two cells lights both");
    check::near(aslant.ahead, aslant.left, 1e-9, "alike");
    check::near(seen(lamp + "[[lamp]]\nposition = [0, 2]\n" + lamp).ahead, 2 * 12.8, 1e-9,
                "lamps add up");
    check::near(seen("[ambient]\nlight = 3\n" + lamp).ahead, 15.8, 1e-9,
                "and the light of the room");
    check::near(seen("[[lamp]]\nposition = [0, 0]\n").ahead, 0.0, 0,
                "a lamp right above is square to all");
}

void shadows()
{
    const std::string lamp = "[[lamp]]\nposition = [2, 0]\n";
    check::that(seen(lamp + "[[wall]]\npoints = [[3, -1], [3, 1]]\n").ahead > 10,
                "a wall behind the lamp hides nothing");
    check::near(seen(lamp + "[[wall]]\npoints = [[1, -1], [1, 1]]\n").ahead, 0.0, 0,
                "a wall before it does");
    check::near(seen(lamp + "[[box]]\ncenter = [1, 0]\nsize = [0.2, 0.2]\n").ahead, 0.0, 0,
                "so does a box");
    check::that(seen(lamp + "[[hole]]\npoints = [[0.5, -1], [1, -1], [1, 1], [0.5, 1]]\n[[tape]]\n"
                            "points = [[1, -1], [1, 1]]\n")
                        .ahead > 10,
                "what is on the floor does not");
}

void noise()
{
    const auto readings = [](std::uint64_t seed, const std::string &rest) {
        Seer seer("[ambient]\nlight = 20\nnoise = 0.1\n" + rest, seed);
        std::vector<double> log;
        for (int k = 1; k <= 2000; ++k)
            log.push_back(seer.at(k * (second / 100)).ahead);
        return log;
    };
    const std::vector<double> log = readings(1, "");
    double mean = 0.0, squares = 0.0;
    for (const double x : log)
        mean += x / static_cast<double>(log.size());
    for (const double x : log)
        squares += (x - mean) * (x - mean) / static_cast<double>(log.size());
    check::near(mean, 20, 0.2, "a photocell's noise has no bias");
    check::near(std::sqrt(squares), 2, 0.15, "and the deviation that was asked for");
    check::that(log == readings(1, "[floor]\nnoise = 0.1\n"),
                "the floor's noise does not change it");
    check::that(log != readings(2, ""), "another seed gives other noise");
}

void floor_below()
{
    const std::string tape =
        "[[tape]]\npoints = [[0, 0.02], [1, 0.02]]\nwidth = 0.02\nreflectance = 0.2\n";
    check::near(seen("").floor, 1.0, 0, "a white floor");
    check::near(seen(tape).floor, 0.2, 1e-12, "tape below the sensor");
    check::near(seen("[[hole]]\npoints = [[0.04, -1], [1, -1], [1, 1], [0.04, 1]]\n").floor, 0.0, 0,
                "no floor below the sensor");
}

// A body table from before these sensors existed.
void without()
{
    frob_body plain = table();
    plain.floor_sensors = nullptr;
    plain.floor_sensor_count = 0;
    plain.floor_spot_m = 0.0;
    plain.photocells = nullptr;
    plain.photocell_count = 0;
    plain.sense = sense_nothing;
    const OwnBody body(plain);
    const RobotKind kind = own_robot_kind(body);
    Simulation s(parse_world("[start]\nx = 0\ny = 0\n[[lamp]]\nposition = [1, 0]\n", "test"), 1,
                 false, &kind);
    s.advance(second);
    Input input;
    s.read(&input);
    check::that(s.time_ns() == second && input.ahead == 0.0,
                "a body without such sensors needs no lamp");
}

void rejects(const std::string &name, const std::string &rest, const std::string &message)
{
    std::string found = "nothing";
    try {
        parse_world("[start]\nx = 0\ny = 0\n" + rest, "w.toml");
    } catch (const WorldFileError &error) {
        found = error.what();
    }
    check::that(found == message, "world file: " + name);
    if (found != message)
        std::printf("     found %s\n", found.c_str());
}

void mistakes()
{
    rejects("a lamp without a place", "[[lamp]]\nintensity = 10\n",
            "w.toml:4:1: this needs a key `position`");
    rejects("a lamp on the floor", "[[lamp]]\nposition = [1, 1]\nheight = 0\n",
            "w.toml:6:10: `height` must be at least 0.01 m");
    rejects("a lamp that takes light away", "[[lamp]]\nposition = [1, 1]\nintensity = -1\n",
            "w.toml:6:13: `intensity` must be more than zero");
    rejects("less than dark", "[ambient]\nlight = -1\n",
            "w.toml:5:9: `light` must be zero or more");
    rejects("one lamp where many may hang", "[lamp]\nposition = [1, 1]\n",
            "w.toml:4:1: `lamp` is a table; write a separate table [[lamp]] for each lamp");
}

} // namespace

int main()
{
    light_of_lamps();
    shadows();
    noise();
    floor_below();
    without();
    mistakes();
    return check::status();
}
