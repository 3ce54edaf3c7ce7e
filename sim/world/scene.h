// What a world file says, as plain data. What it does not mention is ideal:
// no noise, no slip, no drift. Units in the file's key names are converted
// here to metres, radians, seconds, kilograms.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry.h"
#include "look.h"
#include "print.h"

namespace frob::sim
{

// A polyline with a thickness; its corners and free ends are round.
struct Wall {
    std::vector<Vec> points;
    bool closed = false; // the last point is joined to the first
    double thickness = 0.1;
    Look look = { { 0.78, 0.75, 0.69 }, Texture::plaster, 2.5 };
};

// A solid that cannot be moved. Simple (its edges do not cross), not
// necessarily convex, counter-clockwise.
struct Polygon {
    std::vector<Vec> points;
    Look look = { { 0.56, 0.60, 0.66 }, Texture::plaster, 0.8 };
};

struct Circle {
    Vec center;
    double radius = 0.0;
    Look look = { { 0.56, 0.60, 0.66 }, Texture::plaster, 0.8 };
};

// A rectangular box that the robot can push over the floor.
struct Box {
    Pose pose;             // of its middle
    Vec size;              // along its own x and y
    double mass = 2.0;     // kg
    double friction = 0.5; // coefficient between box and floor
    Look look = { { 0.70, 0.53, 0.30 }, Texture::plaster, 0.3 };
};

// A ball on the floor. It rolls along a way, or it lies where it is until it is pushed.
struct Ball {
    std::vector<Vec> way; // at least where it is at first; at its end it turns back
    bool closed = false;  // round and round
    double speed = 0.0;   // m/s
    double radius = 0.1;
    double mass = 0.2; // kg
    Tint tint = { 0.95, 0.42, 0.06 };
};

// A cone that stands fast, as at road works.
struct Cone {
    Vec center;
    double radius = 0.15; // at the floor
    Look look = { { 0.95, 0.42, 0.06 }, Texture::stripes, 0.45 };
};

// A picture that hangs in the room, on a wall or free, and faces one way.
struct Poster {
    Pose pose;           // of its middle, and where it faces
    double middle = 0.5; // m above the floor
    Vec size;            // width and height
    Print print;
};

struct SkyLook {
    Tint tint = { 0.80, 0.85, 0.92 };
};

// A camera on each robot of the world.
struct CameraSettings {
    std::string name = "camera";             // as programs ask for it
    int width = 320, height = 240;           // pixels
    static constexpr int most_pixels = 2048; // of a side
    double field_of_view = radians(60.0);    // across
    double rate = 30.0;                      // Hz
    double latency = 0.0;                    // s from a frame's exposure to the program
    double rolling = 0.0;      // s from the exposure of a frame's first row to that of its last
    double jitter = 0.0;       // s: each frame is taken so much sooner or later at most
    double dropout = 0.0;      // share of frames that are lost
    double noise = 0.0;        // standard deviation of a pixel, of 255
    double exposure = 1.0;     // brightness
    double blur = 0.0;         // pixels, the radius in which light is spread evenly
    double k1 = 0.0, k2 = 0.0; // radial distortion
    bool grey = false;
    // Where it sits and looks; without a value as the robot's is, see chassis.h.
    std::optional<double> ahead, left, up;     // m
    double yaw = 0.0, pitch = 0.0, roll = 0.0; // rad: to the left, down, clockwise
    // Of a pair: m along its rows, to the left of where it would sit otherwise; by how much it is
    // turned without anybody knowing; and the camera, by its number, that takes its frames at the
    // same times.
    double aside = 0.0;
    double askew_yaw = 0.0, askew_pitch = 0.0, askew_roll = 0.0; // rad
    std::optional<std::size_t> partner;
};

// Where a robot starts.
struct Start {
    Pose pose;
    std::string place; // in the file, FILE:LINE:COLUMN, for messages
};

struct DriveSettings {
    // Without a value it is the robot's own, see chassis.h.
    std::optional<double> max_speed;         // m/s
    std::optional<double> max_turn;          // rad/s
    std::optional<double> acceleration;      // m/s^2, to speed up and to brake
    std::optional<double> turn_acceleration; // rad/s^2
    double slip = 0.0;                       // mean share of a wheel's travel that is lost
};

struct OdometrySettings {
    double distance_error = 0.0; // relative: 0.01 counts 1 % too much
    double turn_error = 0.0;     // relative
    double veer = 0.0;           // rad/m: turning counted while going straight
    double heading_noise = 0.0;  // rad per square root of a metre
};

struct SonarSettings {
    double noise = 0.0;   // m, standard deviation
    double dropout = 0.0; // probability that an echo is lost
    int rays = 13;        // across the cone: 2 degrees apart, 17 cm at 5 m
};

struct BatterySettings {
    std::optional<double> voltage; // V at the start; without a value, the robot's own
    double drain = 0.0;            // V/s
};

// What the summary says about following a wall, tape on the floor, or a ball.
struct MeasureSettings {
    enum class What { wall, tape, ball };
    enum class Side { left, right };
    What what = What::wall;
    Side side = Side::left; // of walls
    double distance = 0.5;  // m that the robot should keep, of walls and balls
    double settle = 10.0;   // s that are not counted
};

// A hole in the floor: a cliff, for a robot that sees one.
struct Hole {
    std::vector<Vec> points;
};

// Tape on the floor: a polyline with a width, whose corners and free ends are
// round. Sensors that look down see it, and nothing else does.
struct Tape {
    std::vector<Vec> points; // with the bends at its corners
    bool closed = false;     // the last point is joined to the first
    double width = 0.05;
    double reflectance = 0.05;
    std::optional<Tint> tint; // for cameras; without a value grey, as it reflects
};

// A part of the floor that is brighter or darker than the rest. Simple.
struct Patch {
    std::vector<Vec> points;
    double reflectance = 0.5;
    std::optional<Tint> tint; // likewise
};

struct FloorSettings {
    double reflectance = 1.0;         // share of light that comes back from it
    double noise = 0.0;               // relative standard deviation of what a floor sensor reads
    Tint tint = { 0.66, 0.62, 0.56 }; // for cameras
    Texture texture = Texture::plaster;
};

// A lamp above the floor, which shines in all directions; it is in nobody's way.
struct Lamp {
    Vec position;
    double height = 0.3;     // m above the photocells; for cameras above the floor
    double intensity = 60.0; // cd: a bulb of 750 lm
};

// The light of the room.
struct AmbientSettings {
    double light = 0.0; // lx: what comes from everywhere, beside the lamps
    double noise = 0.0; // relative standard deviation of what a photocell reads
    // lx on a white thing that cameras see as white, by all this light; without a value they see
    // everything in an even light.
    std::optional<double> white;
};

struct LightSettings {
    double noise = 0.0; // relative standard deviation of a light bumper's signal
};

struct Scene {
    std::string name;
    std::string robot;         // "pioneer", …; "" if the file does not say
    std::vector<Start> starts; // a robot at each; one or more
    std::vector<Wall> walls;
    std::vector<Polygon> polygons;
    std::vector<Circle> circles;
    std::vector<Box> boxes;
    std::vector<Ball> balls;
    std::vector<Cone> cones;
    std::vector<Poster> posters;
    std::vector<CameraSettings> cameras;
    SkyLook sky;
    std::vector<Hole> holes;
    std::vector<Patch> patches;
    std::vector<Tape> tapes; // on the patches; of each the later ones lie on the earlier
    DriveSettings drive;
    OdometrySettings odometry;
    SonarSettings sonar;
    std::vector<Lamp> lamps;
    FloorSettings floor;
    AmbientSettings ambient;
    LightSettings light;
    BatterySettings battery;
    std::optional<MeasureSettings> measure;
};

} // namespace frob::sim
