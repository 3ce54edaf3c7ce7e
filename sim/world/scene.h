// What a world file says, as plain data. What it does not mention is ideal:
// no noise, no slip, no drift. Units in the file's key names are converted
// here to metres, radians, seconds, kilograms.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry.h"

namespace frob::sim {

// A polyline with a thickness; its corners and free ends are round.
struct Wall {
    std::vector<Vec> points;
    bool closed = false; // the last point is joined to the first
    double thickness = 0.1;
};

// A solid that cannot be moved. Simple (its edges do not cross), not
// necessarily convex, counter-clockwise.
struct Polygon {
    std::vector<Vec> points;
};

struct Circle {
    Vec center;
    double radius = 0.0;
};

// A rectangular box that the robot can push over the floor.
struct Box {
    Pose pose;           // of its middle
    Vec size;            // along its own x and y
    double mass = 2.0;   // kg
    double friction = 0.5; // coefficient between box and floor
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
    double slip = 0.0; // mean share of a wheel's travel that is lost
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

// What the summary says about following a wall, or tape on the floor.
struct MeasureSettings {
    enum class What { wall, tape };
    enum class Side { left, right };
    What what = What::wall;
    Side side = Side::left;      // of walls, this and the distance
    double distance = 0.5; // m that the robot should keep
    double settle = 10.0;  // s that are not counted
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
};

// A part of the floor that is brighter or darker than the rest. Simple.
struct Patch {
    std::vector<Vec> points;
    double reflectance = 0.5;
};

struct FloorSettings {
    double reflectance = 1.0; // share of light that comes back from it
    double noise = 0.0;       // relative standard deviation of what a floor sensor reads
};

// A lamp above the floor, which shines in all directions; it is in nobody's way.
struct Lamp {
    Vec position;
    double height = 0.3;     // m above the photocells
    double intensity = 60.0; // cd: a bulb of 750 lm
};

// The light of the room, for photocells.
struct AmbientSettings {
    double light = 0.0; // lx: what comes from everywhere, beside the lamps
    double noise = 0.0; // relative standard deviation of what a photocell reads
};

struct LightSettings {
    double noise = 0.0; // relative standard deviation of a light bumper's signal
};

struct Scene {
    std::string name;
    std::string robot; // "pioneer", …; "" if the file does not say
    std::vector<Start> starts; // a robot at each; one or more
    std::vector<Wall> walls;
    std::vector<Polygon> polygons;
    std::vector<Circle> circles;
    std::vector<Box> boxes;
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
