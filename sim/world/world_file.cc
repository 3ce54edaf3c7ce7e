#include "world_file.h"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

#include "devices_file.h"
#include "objects_file.h"
#include "robot.h"
#include "toml_reader.h"
#include "toml_syntax.h"

namespace frob::sim {
namespace {

constexpr int most_robots = 10'000;

// Limits on the size of a world. Larger worlds run slower than real time or need a gigabyte of
// memory.
constexpr std::size_t most_bytes = 4 << 20; // maximum size of the file
constexpr std::size_t most_boxes = 2'000, most_in_one_place = 16;

// Reads the starting pose of one robot, or of `count` robots placed `spacing` apart in rows of
// `columns` robots: the first row runs from (x, y) along x, and the following rows are offset along
// y.
void read_start(TomlReader reader, std::vector<Start> &starts) {
    Pose pose;
    pose.position.x = reader.needed_number("x", Range::any);
    pose.position.y = reader.needed_number("y", Range::any);
    pose.heading = radians(reader.number("heading_deg", 0.0, Range::any));
    const int count = reader.integer("count", 1, 1, most_robots);
    const int square = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count))));
    const int columns = reader.integer("columns", square, 1, most_robots);
    const double spacing = count > 1 ? reader.needed_number("spacing", Range::size)
                                     : reader.number("spacing", 1.0, Range::size);
    for (int k = 0; k < count; ++k) {
        const Vec place = {static_cast<double>(k % columns), static_cast<double>(k / columns)};
        starts.push_back({{pose.position + spacing * place, pose.heading}, reader.place()});
    }
    reader.finish();
}

// Checks that devices of one kind have different names.
template <typename Settings>
void look_at_names(TomlReader &reader, const char *kind, const std::vector<Settings> &devices) {
    for (std::size_t i = 0; i < devices.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (devices[i].name == devices[j].name)
                return reader.mistake("two " + std::string(kind) + " are named `" +
                                      devices[i].name + "`: give each one its own `name`");
}

// Limits the number of boxes. Overlapping boxes are pushed apart, pair by pair. A few of them form
// a heap, but hundreds in one place suggest a mistake in the program that wrote the file.
void look_at_boxes(TomlReader &reader, const std::vector<Box> &boxes) {
    if (boxes.size() > most_boxes)
        return reader.mistake("a world can have at most " + std::to_string(most_boxes) +
                              " boxes, but this one has " + std::to_string(boxes.size()));
    const auto reach = [](const Box &box) { return 0.5 * std::min(box.size.x, box.size.y); };
    for (const Box &box : boxes) {
        std::size_t others = 0;
        for (const Box &other : boxes)
            if (length(other.pose.position - box.pose.position) < reach(box) + reach(other))
                ++others;
        if (others > most_in_one_place)
            return reader.mistake(std::to_string(others) + " boxes overlap at [" +
                                  shown(box.pose.position.x) + ", " + shown(box.pose.position.y) +
                                  "]; at most " + std::to_string(most_in_one_place) +
                                  " may overlap");
    }
}

void look_at_points(TomlReader &reader, const Scene &scene) {
    std::size_t points = 0;
    const auto add = [&](const auto &things) {
        for (const auto &thing : things) points += thing.points.size();
    };
    add(scene.walls), add(scene.polygons), add(scene.holes), add(scene.patches), add(scene.tapes);
    if (points > most_points)
        reader.mistake("a world's walls, polygons, holes, patches and tapes can have at most " +
                       std::to_string(most_points) + " points, but here they have " +
                       std::to_string(points));
}

std::optional<double> in_radians(std::optional<double> angle) {
    return angle ? std::optional(radians(*angle)) : std::nullopt;
}

DriveSettings read_drive(TomlReader reader) {
    DriveSettings drive;
    drive.max_speed = reader.optional_number("max_speed", Range::positive);
    drive.max_turn = in_radians(reader.optional_number("max_turn_deg", Range::positive));
    drive.acceleration = reader.optional_number("acceleration", Range::positive);
    drive.turn_acceleration =
        in_radians(reader.optional_number("turn_acceleration_deg", Range::positive));
    drive.slip = reader.number("slip", drive.slip, Range::share);
    if (drive.slip > 0.5) reader.mistake_at("slip", "`slip` must be at most 0.5");
    reader.finish();
    return drive;
}

OdometrySettings read_odometry(TomlReader reader) {
    OdometrySettings odometry;
    odometry.distance_error = reader.number("distance_error", 0.0, Range::error);
    odometry.turn_error = reader.number("turn_error", 0.0, Range::error);
    odometry.veer = radians(reader.number("veer_deg", 0.0, Range::turn));
    odometry.heading_noise = radians(reader.number("heading_noise_deg", 0.0, Range::turn));
    if (odometry.heading_noise < 0.0)
        reader.mistake_at("heading_noise_deg", "`heading_noise_deg` must be zero or more");
    reader.finish();
    return odometry;
}

SonarSettings read_sonar(TomlReader reader) {
    SonarSettings sonar;
    sonar.noise = reader.number("noise", sonar.noise, Range::not_negative);
    sonar.dropout = reader.number("dropout", sonar.dropout, Range::share);
    sonar.rays = reader.integer("rays", sonar.rays, 1, 101);
    reader.finish();
    return sonar;
}

LightSettings read_light(TomlReader reader) {
    LightSettings light;
    light.noise = reader.number("noise", light.noise, Range::not_negative);
    reader.finish();
    return light;
}

AmbientSettings read_ambient(TomlReader reader, bool has_lamps) {
    AmbientSettings ambient;
    ambient.light = reader.number("light", ambient.light, Range::not_negative);
    ambient.noise = reader.number("noise", ambient.noise, Range::not_negative);
    ambient.white = reader.optional_number("white", Range::positive);
    if (ambient.white && ambient.light == 0.0 && !has_lamps)
        reader.mistake_at("white", "with `white`, cameras need light, but this world has "
                                   "none: add `light`, or a table [[lamp]]");
    reader.finish();
    return ambient;
}

FloorSettings read_floor(TomlReader reader) {
    FloorSettings floor;
    floor.reflectance = reader.number("reflectance", floor.reflectance, Range::part);
    floor.noise = reader.number("noise", floor.noise, Range::not_negative);
    floor.tint = read_tint(reader, "colour", floor.tint);
    floor.texture = read_texture(reader, floor.texture);
    reader.finish();
    return floor;
}

std::string read_robot(TomlReader &reader) {
    const std::string robot = reader.string("robot");
    if (robot.empty() || robot_kind(robot) != nullptr) return robot;
    std::string known;
    for (const RobotKind &kind : robot_kinds())
        known += std::string(known.empty() ? "" : ", ") + kind.name;
    reader.mistake_at("robot", "there is no robot `" + robot + "`; the robots are " + known +
                                   "; remove `robot` if the world is for your own robot");
    return robot;
}

OutageSettings read_outage(TomlReader reader) {
    OutageSettings outage;
    outage.from = reader.number("from", outage.from, Range::not_negative);
    outage.lasts = reader.number("lasts", outage.lasts, Range::not_negative);
    outage.every = reader.number("every", outage.every, Range::not_negative);
    if (outage.every > 0 && outage.every <= outage.lasts)
        reader.mistake_at(
            "every",
            "the next outage begins before this one is over: make `every` longer than `lasts`");
    reader.finish();
    return outage;
}

BatterySettings read_battery(TomlReader reader) {
    BatterySettings battery;
    battery.voltage = reader.optional_number("voltage", Range::positive);
    battery.drain = reader.number("drain", battery.drain, Range::not_negative);
    reader.finish();
    return battery;
}

MeasureSettings read_measure(TomlReader reader) {
    MeasureSettings measure;
    const std::string what = reader.string("what");
    if (what == "tape") {
        measure.what = MeasureSettings::What::tape;
        measure.settle = reader.number("settle", measure.settle, Range::not_negative);
        reader.finish();
        return measure;
    }
    if (what == "ball") {
        measure.what = MeasureSettings::What::ball;
        measure.distance = reader.needed_number("distance", Range::positive);
        measure.settle = reader.number("settle", measure.settle, Range::not_negative);
        reader.finish();
        return measure;
    }
    if (!what.empty() && what != "wall")
        reader.mistake_at("what", "`what` must be \"wall\", \"tape\" or \"ball\"");
    const std::string side = reader.string("side");
    if (side == "right")
        measure.side = MeasureSettings::Side::right;
    else if (!side.empty() && side != "left")
        reader.mistake_at("side", "`side` must be \"left\" or \"right\"");
    measure.distance = reader.needed_number("distance", Range::positive);
    measure.settle = reader.number("settle", measure.settle, Range::not_negative);
    reader.finish();
    return measure;
}

Scene read_scene(Mistakes &mistakes, const toml::table &root, const std::string &folder) {
    TomlReader reader(mistakes, root);
    const auto inside = [&](const toml::table *table) { return TomlReader(mistakes, *table); };
    Scene scene;
    scene.name = reader.string("name");
    scene.robot = read_robot(reader);
    for (const toml::table *table : reader.table_or_tables("start"))
        read_start(inside(table), scene.starts);
    const toml::node *start = root.get("start");
    if (start == nullptr || (start->is_array() && start->as_array()->empty()))
        reader.mistake("a world needs a table [start] with `x` and `y`, the position at which the "
                       "robot starts");
    if (scene.starts.size() > most_robots)
        reader.mistake("a world can have at most " + std::to_string(most_robots) +
                       " robots, but this one has " + std::to_string(scene.starts.size()));
    for (const toml::table *table : reader.tables("wall"))
        scene.walls.push_back(read_wall(inside(table)));
    for (const toml::table *table : reader.tables("polygon"))
        scene.polygons.push_back(read_polygon(inside(table)));
    for (const toml::table *table : reader.tables("circle"))
        scene.circles.push_back(read_circle(inside(table)));
    for (const toml::table *table : reader.tables("box"))
        scene.boxes.push_back(read_box(inside(table)));
    for (const toml::table *table : reader.tables("ball"))
        scene.balls.push_back(read_ball(inside(table), table->contains("way")));
    for (const toml::table *table : reader.tables("cone"))
        scene.cones.push_back(read_cone(inside(table)));
    for (const toml::table *table : reader.tables("poster"))
        scene.posters.push_back(read_poster(inside(table), folder));
    for (const toml::table *table : reader.tables("tag"))
        scene.posters.push_back(read_tag(inside(table)));
    for (const toml::table *table : reader.table_or_tables("camera"))
        scene.cameras.push_back(read_camera(inside(table)));
    if (const toml::table *table = reader.table("stereo"))
        read_stereo(inside(table), scene.cameras);
    look_at_names(reader, "cameras", scene.cameras);
    for (const toml::table *table : reader.table_or_tables("lidar"))
        scene.lidars.push_back(read_lidar(inside(table)));
    look_at_names(reader, "lidars", scene.lidars);
    for (const toml::table *table : reader.table_or_tables("imu"))
        scene.imus.push_back(read_imu(inside(table)));
    look_at_names(reader, "inertial measurement units", scene.imus);
    for (const toml::table *table : reader.tables("magnet"))
        scene.magnets.push_back(read_magnet(inside(table)));
    if (const toml::table *table = reader.table("sky")) {
        TomlReader sky = inside(table);
        scene.sky.tint = read_tint(sky, "colour", scene.sky.tint);
        sky.finish();
    }
    for (const toml::table *table : reader.tables("hole"))
        scene.holes.push_back(read_hole(inside(table)));
    for (const toml::table *table : reader.tables("patch"))
        scene.patches.push_back(read_patch(inside(table)));
    for (const toml::table *table : reader.tables("tape"))
        scene.tapes.push_back(read_tape(inside(table)));
    for (const toml::table *table : reader.tables("lamp"))
        scene.lamps.push_back(read_lamp(inside(table)));
    if (const toml::table *table = reader.table("ambient"))
        scene.ambient = read_ambient(inside(table), !scene.lamps.empty());
    if (const toml::table *table = reader.table("floor")) scene.floor = read_floor(inside(table));
    if (const toml::table *table = reader.table("light")) scene.light = read_light(inside(table));
    if (const toml::table *table = reader.table("drive")) scene.drive = read_drive(inside(table));
    if (const toml::table *table = reader.table("odometry"))
        scene.odometry = read_odometry(inside(table));
    if (const toml::table *table = reader.table("sonar")) scene.sonar = read_sonar(inside(table));
    if (const toml::table *table = reader.table("battery"))
        scene.battery = read_battery(inside(table));
    if (const toml::table *table = reader.table("outage"))
        scene.outage = read_outage(inside(table));
    if (const toml::table *table = reader.table("measure"))
        scene.measure = read_measure(inside(table));
    if (scene.measure && scene.measure->what == MeasureSettings::What::tape && scene.tapes.empty())
        reader.mistake_at("measure", "`measure` needs a [[tape]], but this world has none");
    if (scene.measure && scene.measure->what == MeasureSettings::What::ball && scene.balls.empty())
        reader.mistake_at("measure", "`measure` needs a [[ball]], but this world has none");
    look_at_boxes(reader, scene.boxes);
    look_at_points(reader, scene);
    reader.finish();
    return scene;
}

} // namespace

Scene parse_world(const std::string &text, const std::string &path) {
    Mistakes mistakes(path);
    try {
        const toml::table root = toml::parse(text);
        const std::size_t slash = path.find_last_of('/');
        const std::string folder = slash == std::string::npos ? "" : path.substr(0, slash + 1);
        Scene scene = read_scene(mistakes, root, folder);
        if (!mistakes.any()) return scene;
    } catch (const toml::parse_error &error) {
        const toml::source_region &where = error.source();
        mistakes.add(
            where, syntax_mistake(text, where.begin.line, where.begin.column, error.description()));
    }
    throw WorldFileError(mistakes.text());
}

Scene read_world_file(const std::string &path) {
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    std::string text;
    try {
        // Opening a folder succeeds; only reading it fails.
        file.exceptions(std::ios::badbit | std::ios::failbit);
        file.peek();
        file.exceptions(std::ios::badbit);
        for (std::istreambuf_iterator<char> at(file), end; at != end && text.size() <= most_bytes;
             ++at)
            text.push_back(*at);
    } catch (const std::ios::failure &) {
        if (errno == ENOENT) throw WorldFileError(path + ": there is no such world file");
        throw WorldFileError(path + ": cannot read this world file: " + std::strerror(errno));
    }
    if (text.size() > most_bytes)
        throw WorldFileError(path +
                             ": this file is longer than 4 MB, the maximum for a world file");
    return parse_world(text, path);
}

} // namespace frob::sim
