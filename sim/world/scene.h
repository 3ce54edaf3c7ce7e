// The contents of a world file as plain data. Defaults are ideal: no noise, no slip, no drift. The
// units in the file's key names have been converted to metres, radians, seconds and kilograms.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry.h"
#include "look.h"
#include "print.h"

namespace frob::sim {

// A polyline with a thickness; its corners and free ends are round.
struct Wall {
    std::vector<Vec> points;
    bool closed = false; // whether the last point is joined to the first
    double thickness = 0.1;
    Look look = {{0.78, 0.75, 0.69}, Texture::plaster, 2.5};
    std::string place; // FILE:LINE:COLUMN in the world file, for messages
};

// An immovable solid. Its outline is simple (the edges do not cross), counter-clockwise, and not
// necessarily convex.
struct Polygon {
    std::vector<Vec> points;
    Look look = {{0.56, 0.60, 0.66}, Texture::plaster, 0.8};
    std::string place; // FILE:LINE:COLUMN in the world file, for messages
};

struct Circle {
    Vec center;
    double radius = 0.0;
    Look look = {{0.56, 0.60, 0.66}, Texture::plaster, 0.8};
    std::string place; // FILE:LINE:COLUMN in the world file, for messages
};

// A rectangular box that the robot can push across the floor.
struct Box {
    Pose pose;             // pose of its centre
    Vec size;              // size along the box's x and y axes
    double mass = 2.0;     // kg
    double friction = 0.5; // friction coefficient between box and floor
    Look look = {{0.70, 0.53, 0.30}, Texture::plaster, 0.3};
    std::string place; // FILE:LINE:COLUMN in the world file, for messages
};

// A ball on the floor. It rolls along a path, or lies still until it is pushed.
struct Ball {
    std::vector<Vec> way; // the path, which is a single point if the ball lies still; at the end of
                          // an open path, the ball rolls back
    bool closed = false;  // whether the path leads from its end back to its start
    double speed = 0.0;   // m/s
    double radius = 0.1;
    double mass = 0.2; // kg
    Tint tint = {0.95, 0.42, 0.06};
    std::string place; // FILE:LINE:COLUMN in the world file, for messages
};

// An immovable cone, such as a traffic cone.
struct Cone {
    Vec center;
    double radius = 0.15; // at the floor
    Look look = {{0.95, 0.42, 0.06}, Texture::stripes, 0.45};
    std::string place; // FILE:LINE:COLUMN in the world file, for messages
};

// A picture that hangs on a wall or freely in the room. It is visible from one side only.
struct Poster {
    Pose pose;           // position of the picture's centre, and the direction in which it faces
    double middle = 0.5; // m, height of the centre above the floor
    Vec size;            // width and height
    Print print;
};

struct SkyLook {
    Tint tint = {0.80, 0.85, 0.92};
};

// A camera that each robot in the world carries.
struct CameraSettings {
    std::string name = "camera";             // the name that programs use
    int width = 320, height = 240;           // pixels
    static constexpr int most_pixels = 2048; // maximum width and height
    double field_of_view = radians(60.0);    // horizontal
    double rate = 30.0;                      // Hz
    double latency = 0.0;                    // s, from a frame's exposure until the program
                                             // receives it
    double rolling = 0.0;      // s, between the exposures of a frame's first and last rows
    double jitter = 0.0;       // s, maximum deviation from a frame's regular time
    double dropout = 0.0;      // fraction of frames that are lost
    double noise = 0.0;        // standard deviation of a pixel's value, on the scale from 0 to 255
    double exposure = 1.0;     // brightness
    double blur = 0.0;         // pixels, radius of the box blur
    double k1 = 0.0, k2 = 0.0; // radial distortion
    bool grey = false;
    // Position and direction on the robot. If there is no value, the robot's default applies (see
    // chassis.h).
    std::optional<double> ahead, left, up;     // m
    double yaw = 0.0, pitch = 0.0, roll = 0.0; // rad: to the left, down, clockwise
    // For cameras of a stereo pair: `aside` is the offset along the camera's rows, in m to the
    // left; the `askew_` angles are a misalignment that programs do not know about; `partner` is
    // the index of the camera that takes its frames at the same times.
    double aside = 0.0;
    double askew_yaw = 0.0, askew_pitch = 0.0, askew_roll = 0.0; // rad
    std::optional<std::size_t> partner;
};

// A lidar that each robot in the world carries.
struct LidarSettings {
    std::string name = "lidar"; // the name that programs use
    int rays = 360;             // rays in a scan
    static constexpr int most_rays = 4096;
    double field_of_view = radians(360.0);
    double nearest = 0.1, farthest = 12.0; // m, its range
    double rate = 10.0;                    // scans per second
    double latency = 0.0;                  // s, from a scan until the program receives it
    double noise = 0.0;                    // m, standard deviation
    double dropout = 0.0;                  // probability that a ray is lost
    double ahead = 0.0, left = 0.0;        // m, its position on the robot
    double yaw = 0.0;                      // rad, its rotation to the left
    // Sectors in which parts of the robot block the rays: from the first bearing to the second,
    // counter-clockwise, relative to the robot's heading.
    std::vector<Vec> masks; // rad
};

// An inertial measurement unit that each robot in the world carries.
struct ImuSettings {
    std::string name = "imu"; // the name that programs use
    double rate = 100.0;      // measurements per second
    double latency = 0.0;     // s, from a measurement until the program receives it
    // The gyroscope. The bias is drawn at the start of each run; `gyro_bias` is its standard
    // deviation over all runs.
    double gyro_noise = 0.0; // rad/s, standard deviation
    double gyro_bias = 0.0;  // rad/s
    double gyro_drift = 0.0; // rad/s per square root of a second; the bias performs a random walk
    double gyro_scale = 0.0; // relative error
    // The accelerometer.
    double acceleration_noise = 0.0; // m/s^2
    double acceleration_bias = 0.0;  // m/s^2
    // The magnetometer.
    bool compass = true;
    double compass_noise = 0.0; // rad, standard deviation
    double compass_error = 0.0; // rad, constant
};

// A magnet, which deflects compasses.
struct Magnet {
    Vec position;
    double strength = 0.0; // its field at 1 m, relative to the Earth's horizontal field
};

// A robot's starting pose.
struct Start {
    Pose pose;
    std::string place; // FILE:LINE:COLUMN in the world file, for messages
};

struct DriveSettings {
    // If there is no value, the robot's default applies (see chassis.h).
    std::optional<double> max_speed;         // m/s
    std::optional<double> max_turn;          // rad/s
    std::optional<double> acceleration;      // m/s^2, when speeding up and braking
    std::optional<double> turn_acceleration; // rad/s^2
    double slip = 0.0;                       // mean fraction of a wheel's travel that is lost
    bool behind_wire = false; // whether commands come from firmware, which has already rounded
                              // them; not a setting in the world file
};

struct OdometrySettings {
    double distance_error = 0.0; // relative error: 0.01 means a reading that is 1 % too large
    double turn_error = 0.0;     // relative
    double veer = 0.0;           // rad/m, the turn that odometry wrongly reports on a straight line
    double heading_noise = 0.0;  // rad per square root of a metre
};

struct SonarSettings {
    double noise = 0.0;   // m, standard deviation
    double dropout = 0.0; // probability that an echo is lost
    int rays = 13;        // rays across the cone, 2 degrees apart, which is 17 cm at 5 m
};

struct BatterySettings {
    std::optional<double> voltage; // V, the initial voltage; without a value, the robot's default
    double drain = 0.0;            // V/s
};

// Times during which the host has lost the robot, as if the cable were unplugged, and the program
// does not run.
struct OutageSettings {
    double from = 0.0;  // s
    double lasts = 0.0; // s; 0 if there is no outage
    double every = 0.0; // s, between the starts of outages; 0 if there is only one
};

// The quantity that the summary reports: how well the robot follows a wall, a tape on the floor, or
// a ball.
struct MeasureSettings {
    enum class What { wall, tape, ball };
    enum class Side { left, right };
    What what = What::wall;
    Side side = Side::left; // for walls
    double distance = 0.5;  // m, the distance to keep from a wall or ball
    double settle = 10.0;   // s, the time at the start that is excluded from the measurement
};

// A hole in the floor, which a robot with cliff sensors detects as a cliff.
struct Hole {
    std::vector<Vec> points;
};

// Tape on the floor: a polyline with a width; its corners and free ends are round. Only cameras and
// downward-facing sensors see it.
struct Tape {
    std::vector<Vec> points; // including the arcs at its corners
    bool closed = false;     // whether the last point is joined to the first
    double width = 0.05;
    double reflectance = 0.05;
    std::optional<Tint> tint; // for cameras; without a value, the floor's tint scaled by the
                              // reflectance
};

// A part of the floor that is brighter or darker than the rest. Its outline is simple.
struct Patch {
    std::vector<Vec> points;
    double reflectance = 0.5;
    std::optional<Tint> tint; // for cameras; without a value, the floor's tint scaled by the
                              // reflectance
};

struct FloorSettings {
    double reflectance = 1.0;       // fraction of light that the floor reflects
    double noise = 0.0;             // relative standard deviation of a floor sensor's reading
    Tint tint = {0.66, 0.62, 0.56}; // for cameras
    Texture texture = Texture::plaster;
};

// A lamp above the floor. It shines in all directions and is not an obstacle.
struct Lamp {
    Vec position;
    double height = 0.3;     // m, height above the photocells or, for cameras, above the floor
    double intensity = 60.0; // cd; the default is that of a 750 lm bulb
};

// The ambient light of the room.
struct AmbientSettings {
    double light = 0.0; // lx from all directions, in addition to the lamps
    double noise = 0.0; // relative standard deviation of a photocell's reading
    // The illuminance in lx, from all sources, at which a white surface appears fully white to
    // cameras. Without a value, cameras see everything evenly lit.
    std::optional<double> white;
};

struct LightSettings {
    double noise = 0.0; // relative standard deviation of a light bumper's signal
};

struct Scene {
    std::string name;
    std::string robot;         // "pioneer", …; "" if the file does not name a robot
    std::vector<Start> starts; // one for each robot; at least one
    std::vector<Wall> walls;
    std::vector<Polygon> polygons;
    std::vector<Circle> circles;
    std::vector<Box> boxes;
    std::vector<Ball> balls;
    std::vector<Cone> cones;
    std::vector<Poster> posters;
    std::vector<CameraSettings> cameras;
    std::vector<LidarSettings> lidars;
    std::vector<ImuSettings> imus;
    std::vector<Magnet> magnets;
    SkyLook sky;
    std::vector<Hole> holes;
    std::vector<Patch> patches;
    std::vector<Tape> tapes; // above the patches; later tapes and patches lie on earlier ones
    DriveSettings drive;
    OdometrySettings odometry;
    SonarSettings sonar;
    std::vector<Lamp> lamps;
    FloorSettings floor;
    AmbientSettings ambient;
    LightSettings light;
    BatterySettings battery;
    OutageSettings outage;
    std::optional<MeasureSettings> measure;
};

} // namespace frob::sim
