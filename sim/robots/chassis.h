// A robot's body, its wheels, and where it looks from: what the physics, the
// measurements and the picture know of a robot. The robot's frame: origin midway
// between the driving wheels, x forward, y left.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry.h"

namespace frob::sim
{

// What the firmware limits commands to, where the world file does not say.
struct DriveLimits {
    double speed;             // m/s
    double turn;              // rad/s
    double acceleration;      // m/s^2, to speed up and to brake
    double turn_acceleration; // rad/s^2
};

// Transducers that measure distances.
struct RangeFinders {
    std::vector<Pose> seats;        // where they sit and look
    double half_angle;              // of the cone of each
    std::size_t left, right;        // those that look most to the sides
    std::vector<std::size_t> front; // those that look ahead
    const char *noun;               // "sonar", for the picture
};

struct Chassis {
    std::string title;        // "Pioneer P3-DX"
    double mass;              // kg
    double inertia;           // kg m^2, about the origin
    Vec center;               // of the body
    double radius;            // of a round body; 0: it has an outline
    std::vector<Vec> outline; // convex, counter-clockwise, of at most 8 corners
    double wheel_radius;      // m
    double wheel_separation;  // m
    double wheel_force;       // N that a motor can bring to the floor
    double count;             // m that an encoder's count is; 0: as if continuous
    double battery;           // V at the start, where the world file does not say
    DriveLimits limits;
    Vec left, right; // where the distances to the sides are measured from
    RangeFinders range_finders;
    double height = 0.24;        // m, of the body, for cameras
    Vec camera = { 0.12, 0.0 };  // where a camera sits,
    double camera_height = 0.27; // and how high, where the world file does not say
};

// The outline of a body, also of a round one, in the robot's frame.
std::vector<Vec> outline_of(const Chassis &chassis);

} // namespace frob::sim
