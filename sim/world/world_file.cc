#include "world_file.h"

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>

#include "bends.h"
#include "devices_file.h"
#include "robot.h"
#include "toml_reader.h"
#include "toml_syntax.h"
#include "triangulate.h"

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

Tint read_tint(TomlReader &reader, const char *key, Tint otherwise) {
    const std::string text = reader.string(key);
    if (text.empty()) return otherwise;
    if (const std::optional<Tint> tint = tint_of(text)) return *tint;
    reader.mistake_at(key, "there is no colour `" + text + "`; the colours are " + tint_names() +
                               ", and `#rrggbb`");
    return otherwise;
}

std::optional<Tint> read_optional_tint(TomlReader &reader) {
    const Tint none = {-1.0, 0.0, 0.0};
    const Tint tint = read_tint(reader, "colour", none);
    return tint.red < 0.0 ? std::nullopt : std::optional(tint);
}

Texture read_texture(TomlReader &reader, Texture otherwise) {
    const std::string name = reader.string("texture");
    if (name.empty()) return otherwise;
    if (const std::optional<Texture> texture = texture_of(name)) return *texture;
    reader.mistake_at("texture",
                      "there is no texture `" + name + "`; the textures are " + texture_names());
    return otherwise;
}

// Reads how an object looks to cameras.
Look read_look(TomlReader &reader, Look look) {
    look.tint = read_tint(reader, "colour", look.tint);
    look.texture = read_texture(reader, look.texture);
    look.height = reader.number("height", look.height, Range::size);
    return look;
}

Wall read_wall(TomlReader reader) {
    Wall wall;
    wall.closed = reader.boolean("closed", wall.closed);
    wall.points = reader.needed_points("points", wall.closed ? 3 : 2, wall.closed);
    wall.thickness = reader.number("thickness", wall.thickness, Range::size);
    wall.look = read_look(reader, wall.look);
    wall.place = reader.place();
    reader.finish();
    return wall;
}

Polygon read_polygon(TomlReader reader) {
    Polygon polygon;
    polygon.points = reader.needed_points("points", 3, true);
    if (!polygon.points.empty()) {
        if (!is_simple(polygon.points))
            reader.mistake_at("points", "the edges of this polygon cross or touch");
        else if (signed_area(polygon.points) < 0.0)
            polygon.points = {polygon.points.rbegin(), polygon.points.rend()};
    }
    polygon.look = read_look(reader, polygon.look);
    polygon.place = reader.place();
    reader.finish();
    return polygon;
}

Circle read_circle(TomlReader reader) {
    Circle circle;
    circle.center = reader.needed_point("center", Range::any);
    circle.radius = reader.needed_number("radius", Range::size);
    circle.look = read_look(reader, circle.look);
    circle.place = reader.place();
    reader.finish();
    return circle;
}

Box read_box(TomlReader reader) {
    Box box;
    box.pose.position = reader.needed_point("center", Range::any);
    box.pose.heading = radians(reader.number("angle_deg", 0.0, Range::any));
    box.size = reader.needed_point("size", Range::size);
    box.mass = reader.number("mass", box.mass, Range::positive);
    box.friction = reader.number("friction", box.friction, Range::not_negative);
    box.look = read_look(reader, box.look);
    box.place = reader.place();
    reader.finish();
    return box;
}

// Reads a ball that lies still or rolls along a path.
Ball read_ball(TomlReader reader, bool has_way) {
    Ball ball;
    if (has_way) {
        ball.closed = reader.boolean("closed", ball.closed);
        ball.way = reader.needed_points("way", ball.closed ? 3 : 2, ball.closed);
        ball.speed = reader.needed_number("speed", Range::positive);
    } else {
        ball.way = {reader.needed_point("center", Range::any)};
    }
    ball.radius = reader.number("radius", ball.radius, Range::size);
    ball.mass = reader.number("mass", ball.mass, Range::positive);
    ball.tint = read_tint(reader, "colour", ball.tint);
    ball.place = reader.place();
    reader.finish();
    return ball;
}

Cone read_cone(TomlReader reader) {
    Cone cone;
    cone.center = reader.needed_point("center", Range::any);
    cone.radius = reader.number("radius", cone.radius, Range::size);
    cone.look = read_look(reader, cone.look);
    cone.place = reader.place();
    reader.finish();
    return cone;
}

void read_place(TomlReader &reader, Poster &poster) {
    poster.pose.position = reader.needed_point("center", Range::any);
    poster.pose.heading = radians(reader.needed_number("facing_deg", Range::any));
    poster.middle = reader.number("middle", poster.middle, Range::any);
}

Poster read_poster(TomlReader reader, const std::string &folder) {
    Poster poster;
    read_place(reader, poster);
    poster.size = reader.needed_point("size", Range::size);
    const std::string picture = reader.needed_string("picture");
    try {
        if (!picture.empty())
            poster.print = Print::of_file(picture[0] == '/' ? picture : folder + picture);
    } catch (const std::runtime_error &error) {
        reader.mistake_at("picture", picture + ": " + error.what());
    }
    reader.finish();
    return poster;
}

// `size` is the width of the black frame, which is eight cells wide; the whole tag is ten cells
// wide.
Poster read_tag(TomlReader reader) {
    Poster tag;
    read_place(reader, tag);
    const double size = 10.0 / 8.0 * reader.needed_number("size", Range::size);
    tag.size = {size, size};
    tag.print = Print::tag(reader.integer("id", 0, 0, Print::tags - 1));
    reader.finish();
    return tag;
}

// Reads the keys that single cameras and stereo pairs share.
CameraSettings read_any_camera(TomlReader &reader) {
    CameraSettings camera;
    camera.width = reader.integer("width", camera.width, 8, CameraSettings::most_pixels);
    camera.height = reader.integer("height", camera.height, 8, CameraSettings::most_pixels);
    camera.field_of_view =
        radians(reader.number("field_of_view_deg", degrees(camera.field_of_view), Range::positive));
    if (camera.field_of_view > radians(150.0))
        reader.mistake_at("field_of_view_deg", "`field_of_view_deg` must be at most 150");
    camera.rate = reader.number("rate", camera.rate, Range::positive);
    if (camera.rate > 200.0)
        reader.mistake_at("rate", "`rate` must be at most 200, the rate of the physics steps");
    camera.latency = reader.number("latency", camera.latency, Range::not_negative);
    camera.rolling = reader.number("rolling", camera.rolling, Range::not_negative);
    if (camera.rolling * camera.rate > 1.0)
        reader.mistake_at("rolling", "`rolling` must be at most 1 / `rate`, the time "
                                     "between frames");
    camera.jitter = reader.number("jitter", camera.jitter, Range::not_negative);
    camera.dropout = reader.number("dropout", camera.dropout, Range::share);
    camera.noise = reader.number("noise", camera.noise, Range::not_negative);
    camera.exposure = reader.number("exposure", camera.exposure, Range::positive);
    camera.blur = reader.integer("blur", 0, 0, 20);
    camera.k1 = reader.number("k1", camera.k1, Range::error);
    camera.k2 = reader.number("k2", camera.k2, Range::error);
    camera.grey = reader.boolean("grey", camera.grey);
    camera.ahead = reader.optional_number("ahead", Range::any);
    camera.left = reader.optional_number("left", Range::any);
    camera.up = reader.optional_number("up", Range::size);
    camera.yaw = radians(reader.number("yaw_deg", 0.0, Range::turn));
    camera.pitch = radians(reader.number("pitch_deg", 0.0, Range::turn));
    camera.roll = radians(reader.number("roll_deg", 0.0, Range::turn));
    return camera;
}

CameraSettings read_camera(TomlReader reader) {
    CameraSettings camera = read_any_camera(reader);
    if (const std::string name = reader.string("name"); !name.empty()) camera.name = name;
    reader.finish();
    return camera;
}

// Reads a stereo pair: two cameras side by side, the right one slightly misaligned.
void read_stereo(TomlReader reader, std::vector<CameraSettings> &cameras) {
    CameraSettings left = read_any_camera(reader);
    const double baseline = reader.number("baseline", 0.12, Range::positive);
    left.name = "left";
    left.aside = baseline / 2;
    CameraSettings right = left;
    right.name = "right";
    right.aside = -baseline / 2;
    right.partner = cameras.size();
    right.askew_yaw = radians(reader.number("askew_yaw_deg", 0.0, Range::turn));
    right.askew_pitch = radians(reader.number("askew_pitch_deg", 0.0, Range::turn));
    right.askew_roll = radians(reader.number("askew_roll_deg", 0.0, Range::turn));
    reader.finish();
    cameras.push_back(left);
    cameras.push_back(right);
}

Magnet read_magnet(TomlReader reader) {
    Magnet magnet;
    magnet.position = reader.needed_point("position", Range::any);
    magnet.strength = reader.needed_number("strength", Range::any);
    reader.finish();
    return magnet;
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

std::string shown(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", x);
    return text;
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

Hole read_hole(TomlReader reader) {
    Hole hole;
    hole.points = reader.needed_points("points", 3, true);
    if (!hole.points.empty() && !is_simple(hole.points))
        reader.mistake_at("points", "the edges of this hole cross or touch");
    reader.finish();
    return hole;
}

Tape read_tape(TomlReader reader) {
    Tape tape;
    tape.closed = reader.boolean("closed", tape.closed);
    tape.points = reader.needed_points("points", tape.closed ? 3 : 2, tape.closed);
    tape.width = reader.number("width", tape.width, Range::size);
    tape.reflectance = reader.number("reflectance", tape.reflectance, Range::part);
    tape.tint = read_optional_tint(reader);
    const double radius = reader.number("radius", 0.0, Range::not_negative);
    if (!tape.points.empty() && radius > 0.0) {
        if (const std::optional<Vec> corner = corner_without_room(tape.points, tape.closed, radius))
            reader.mistake_at("radius",
                              "there is no room for a bend of this radius at the corner [" +
                                  shown(corner->x) + ", " + shown(corner->y) + "]");
        else
            tape.points = with_bends(tape.points, tape.closed, radius);
    }
    reader.finish();
    return tape;
}

Patch read_patch(TomlReader reader) {
    Patch patch;
    patch.points = reader.needed_points("points", 3, true);
    if (!patch.points.empty() && !is_simple(patch.points))
        reader.mistake_at("points", "the edges of this patch cross or touch");
    patch.reflectance = reader.number("reflectance", patch.reflectance, Range::part);
    patch.tint = read_optional_tint(reader);
    reader.finish();
    return patch;
}

Lamp read_lamp(TomlReader reader) {
    Lamp lamp;
    lamp.position = reader.needed_point("position", Range::any);
    lamp.height = reader.number("height", lamp.height, Range::size);
    lamp.intensity = reader.number("intensity", lamp.intensity, Range::positive);
    reader.finish();
    return lamp;
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
